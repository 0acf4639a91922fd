// A blade's level: equations 4 and 5 of Jahrmann and Wimmer 2013, decided in the vertex stage; 0 draws nothing.
layout(vertices = 1) out;

in vec4 bladeRoot[], bladeControl[], bladeTip[], bladeFacing[], bladePaint[];
in vec4 bladeUpright[];
in vec3 bladeControlBefore[], bladeTipBefore[];
in vec3 bladeSlope[];
flat in uint bladeGrain[];
out vec4 stemRoot[], stemControl[], stemTip[], stemFacing[], stemPaint[];
out vec4 stemUpright[];
out vec3 stemControlBefore[], stemTipBefore[];
out vec3 stemSlope[];
flat out uint stemGrain[];

void main() {
    stemRoot[gl_InvocationID] = bladeRoot[gl_InvocationID];
    stemControl[gl_InvocationID] = bladeControl[gl_InvocationID];
    stemTip[gl_InvocationID] = bladeTip[gl_InvocationID];
    stemFacing[gl_InvocationID] = bladeFacing[gl_InvocationID];
    stemPaint[gl_InvocationID] = bladePaint[gl_InvocationID];
    stemUpright[gl_InvocationID] = bladeUpright[gl_InvocationID];
    stemSlope[gl_InvocationID] = bladeSlope[gl_InvocationID];
    stemControlBefore[gl_InvocationID] = bladeControlBefore[gl_InvocationID];
    stemTipBefore[gl_InvocationID] = bladeTipBefore[gl_InvocationID];
    stemGrain[gl_InvocationID] = bladeGrain[gl_InvocationID];
    float along = bladeRoot[gl_InvocationID].w, across = min(along, 1.0);
    gl_TessLevelOuter[0] = along;
    gl_TessLevelOuter[1] = across;
    gl_TessLevelOuter[2] = along;
    gl_TessLevelOuter[3] = across;
    gl_TessLevelInner[0] = across;
    gl_TessLevelInner[1] = along;
}
