-- Layers over a density: rules by clicks, a stroke below them, undo; what was painted stays as it was.
project.new()
local density = "lawn.GrassField.species[lawn].density"
local painted = map.hash(density)
ui.click("Tabs/Layers")
ui.click("Layers/Add rule")
ui.wait(2)
local rule = "lawn.MapLayers.layers[rule]"
expect.equal(entity.get(rule .. ".masks[mask].by"), "slope")
expect.equal(map.hash(density), painted)
ui.click("Layers/" .. rule .. "/Preview")
ui.wait(2)
ui.click("Layers/" .. rule .. "/On")
expect.equal(entity.get(rule .. ".muted"), true)
ui.click("Layers/" .. rule .. "/On")
expect.equal(entity.get(rule .. ".muted"), false)

-- Sand below 1 m, by a rule over the ground's colours: nobody paints it.
entity.set("ground.MapLayers", { layers = { { name = "sand", map = "Terrain.terrainMap", operation = "replace",
    masks = { { by = "height", from = -1000, to = 1 } } } } })
expect.equal(entity.get("ground.Terrain.terrainMap"), nil)
ui.set("Brush/Map", "ground.Terrain.terrainMap")
ui.wait(2)
expect.truthy(ui.exists("Layers/ground.MapLayers.layers[sand].color"))
expect.truthy(not ui.exists("Layers/ground.MapLayers.layers[sand]/Note"))
entity.set("ground.MapLayers.layers[sand].masks[mask].to", -5)
ui.wait(2)
expect.equal(ui.get("Layers/ground.MapLayers.layers[sand]/Note"), "it is 0 everywhere and changes nothing: widen or invert it")
expect.truthy(edit.undo()); expect.truthy(edit.undo())
ui.set("Brush/Map", density)

entity.set(rule .. ".masks[mask].by", "water")
ui.wait(2)
expect.truthy(ui.get("Layers/" .. rule .. "/Note"):find("Skipped: mask \"mask\": the scene has no water", 1, true))
expect.truthy(edit.undo())

brush.select { map = density, mode = "subtract", radius = 3, strength = 1 }
brush.stroke { { 10, 10 }, { 14, 10 } }
expect.truthy(map.hash(density) ~= painted)
expect.truthy(edit.undo())
expect.equal(map.hash(density), painted)

ui.click("Layers/Add painted")
ui.wait(2)
ui.click("Layers/lawn.MapLayers.layers[painted]/Down")
ui.wait(2)
expect.equal(entity.get("lawn.MapLayers").layers[1].name, "painted")
ui.click("Layers/lawn.MapLayers.layers[painted]/Delete")
ui.click("Layers/" .. rule .. "/Delete")
ui.wait(2)
expect.equal(entity.get("lawn").MapLayers, nil)
