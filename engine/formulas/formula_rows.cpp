#include "formulas/formula_rows.h"

#include <algorithm>

#include "formulas/formula_table.h"

namespace sward {

void FormulaSamples::add(const std::vector<double>& in, const std::vector<double>& out,
                         const std::vector<double>& units) {
    for (double v : in) x.push_back(double(float(v)));
    want.insert(want.end(), out.begin(), out.end());
    if (units.empty())
        scale.insert(scale.end(), out.size(), 1.0);
    else
        scale.insert(scale.end(), units.begin(), units.end());
    ++count;
}

std::vector<double> Sweep::direction() {
    const double y = in(-1, 1);
    const double angle = in(-3.14159, 3.14159);
    const double r = std::sqrt(std::max(0.0, 1 - y * y));
    return {double(float(r * std::cos(angle))), y, double(float(r * std::sin(angle)))};
}

namespace {

bool gather(const ExpectedRecord& record, const std::vector<std::string>& fields, std::vector<double>& out) {
    for (const std::string& field : fields) {
        const auto found = record.find(field);
        if (found == record.end()) return false;
        out.insert(out.end(), found->second.begin(), found->second.end());
    }
    return true;
}

}  // namespace

std::function<FormulaSamples(const ExpectedValues&)> fromGroup(std::string group, std::vector<std::string> inputs,
                                                               std::vector<std::string> outputs, FormulaUnit unit) {
    return [=](const ExpectedValues& values) {
        FormulaSamples samples;
        const auto found = values.find(group);
        if (found == values.end()) return samples;
        for (const ExpectedRecord& record : found->second) {
            std::vector<double> in, out, units;
            if (!gather(record, inputs, in) || !gather(record, outputs, out)) continue;
            for (size_t i = 0; i < out.size(); ++i) units.push_back(unit ? unit(record, i, out[i]) : 1.0);
            samples.add(in, out, units);
        }
        return samples;
    };
}

std::function<FormulaSamples(const ExpectedValues&)> sweep(int count,
                                                           std::function<std::vector<double>(Sweep&, int)> make) {
    return [=](const ExpectedValues&) {
        FormulaSamples samples;
        Sweep random(20060101u);
        for (int i = 0; i < count; ++i) samples.add(make(random, i), {});
        return samples;
    };
}

std::function<FormulaSamples(const ExpectedValues&)> listed(std::vector<std::vector<double>> inputs,
                                                            std::vector<std::vector<double>> want) {
    return [=](const ExpectedValues&) {
        FormulaSamples samples;
        for (size_t i = 0; i < inputs.size(); ++i) {
            std::vector<double> in;
            for (double v : inputs[i]) in.push_back(double(float(v)));
            samples.add(in, want.empty() ? std::vector<double>{} : want[i]);
        }
        return samples;
    };
}

double relativeUnit(const ExpectedRecord&, size_t, double want) { return want == 0 ? 1.0 : std::abs(want); }
double relativeError(double got, double want, double scale) {
    return std::abs(got - want) / std::max(std::abs(want), scale);
}
double circleError(double got, double want, double scale) {
    const double d = std::abs(got - want);
    return std::min(d, std::abs(1 - d)) / scale;
}
double excessError(double got, double want, double scale) {
    return std::isnan(got) ? got : std::max(got - want, 0.0) / scale;
}

FormulaSamples samplesOf(const FormulaRow& row, const ExpectedValues& values) {
    FormulaSamples samples = row.samples(values);
    if (!samples.want.empty() || samples.count == 0) return samples;
    samples.want = runDouble(row, row.ours, samples);
    samples.scale.assign(samples.want.size(), 1.0);
    return samples;
}

double largestError(const FormulaRow& row, const FormulaSamples& samples, const std::vector<double>& outputs) {
    double worst = 0;
    for (size_t i = 0; i < outputs.size(); ++i) {
        if (std::isnan(samples.want[i])) continue;
        const double error = row.error ? row.error(outputs[i], samples.want[i], samples.scale[i])
                             : outputs[i] == samples.want[i]
                                 ? 0.0
                                 : std::abs(outputs[i] - samples.want[i]) / samples.scale[i];
        if (std::isnan(error)) return error;
        worst = std::max(worst, error);
    }
    return worst;
}

int outOfRange(const FormulaRow& row, const std::vector<double>& outputs) {
    return int(std::count_if(outputs.begin(), outputs.end(),
                             [&](double v) { return !(std::isfinite(v) && v >= row.low && v <= row.high); }));
}

namespace {

template <class T, class Function>
std::vector<double> runBody(const FormulaRow& row, Function body, const FormulaSamples& samples) {
    std::vector<double> outputs;
    outputs.reserve(size_t(samples.count) * size_t(row.outputs));
    std::vector<T> x(static_cast<size_t>(row.inputs)), y(static_cast<size_t>(row.outputs));
    for (int i = 0; i < samples.count; ++i) {
        for (size_t k = 0; k < x.size(); ++k) x[k] = T(samples.x[size_t(i) * x.size() + k]);
        std::fill(y.begin(), y.end(), T(0));
        body(x.data(), y.data());
        outputs.insert(outputs.end(), y.begin(), y.end());
    }
    return outputs;
}

}  // namespace

std::vector<double> runSingle(const FormulaRow& row, const FormulaBody& body, const FormulaSamples& samples) {
    return runBody<float>(row, body.single, samples);
}
std::vector<double> runDouble(const FormulaRow& row, const FormulaBody& body, const FormulaSamples& samples) {
    return runBody<double>(row, body.twice, samples);
}

std::vector<FormulaRow> formulaRows() {
    std::vector<FormulaRow> rows;
    addHybridRows(rows);
    addHybridShapeRows(rows);
    addForestRows(rows);
    addRayRows(rows);
    addBladeRows(rows);
    addSceneRows(rows);
    addAgreementRows(rows);
    return rows;
}

}  // namespace sward
