#include "formulas/kernels.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include "cost/cost.h"
#include "cost/cost_times.h"
#include "formulas/kernels_gpu.h"

namespace sward {
namespace {

// --- which forms a formula has

// A row whose own form is one of several of a formula, as `name` in its list.
struct NamedForm {
    const char* row;
    const char* name;
    bool alone = false;  // its own samples differ from the base's: it is listed by itself too
};
// The rows that are forms of one formula: `name` stands in place of the base row, which gives samples and measure of
// error.
struct KernelForms {
    const char* base;
    const char* name;
    bool sameUnit;  // the rows' tolerances hold over the base's samples
    std::vector<NamedForm> forms;
};
const std::vector<KernelForms>& severalForms() {
    static const std::vector<KernelForms> several = {
        {"light weights, three atan",
         "light weights, eqs 8-13",
         true,
         {{"light weights, three atan", "three atan"},
          {"light weights, two atan and remainder", "two atan and remainder"},
          {"light weights, degree 13", "degree 13"},
          {"light weights, degree 9", "degree 9"},
          {"light weights, degree 7", "degree 7"},
          {"light weights, degree 5", "degree 5"},
          {"light weights, degree 3", "degree 3"},
          {"light weights, normalised components", "normalised components"},
          {"light weights, squares", "squares"}}},
        {"opacity correction, pow",
         "opacity correction, 8 bits",
         true,
         {{"opacity correction, series, relative", "series", true},
          {"opacity correction, pow", "pow"},
          {"opacity correction, hyperbola", "hyperbola"}}},
        {"opacity correction of thin layers, relative",
         "opacity correction of thin layers, relative",
         false,
         {{"opacity correction of thin layers, relative", "series"},
          {"opacity correction, pow", "pow"},
          {"opacity correction, hyperbola", "hyperbola"}}},
    };
    return several;
}

const FormulaRow& rowNamed(const std::vector<FormulaRow>& rows, const std::string& name) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const FormulaRow& r) { return r.name == name; });
    if (found == rows.end()) checkFailed(__FILE__, __LINE__, "no row is named " + name);
    return *found;
}
const KernelForms* formsOf(const FormulaRow& row) {
    for (const KernelForms& f : severalForms())
        if (row.name == f.base) return &f;
    return nullptr;
}
bool isFormOfAnother(const FormulaRow& row) {
    if (formsOf(row)) return false;
    for (const KernelForms& f : severalForms())
        for (const NamedForm& form : f.forms)
            if (row.name == form.row && !form.alone) return true;
    return false;
}

void append(FormulaSamples& to, const FormulaSamples& more) {
    to.count += more.count;
    to.x.insert(to.x.end(), more.x.begin(), more.x.end());
    to.want.insert(to.want.end(), more.want.begin(), more.want.end());
    to.scale.insert(to.scale.end(), more.scale.begin(), more.scale.end());
}

Kernel kernelOf(const FormulaRow& row, const std::vector<FormulaRow>& rows, const ExpectedValues& values) {
    Kernel k;
    k.row = row;
    k.samples = samplesOf(row, values);
    append(k.samples, kernelDomain(row));
    k.forms.push_back({"published", row.published});
    const KernelForms* several = formsOf(row);
    if (!several) {
        k.forms.push_back({"ours", row.ours, row.tolerance});
        return k;
    }
    k.row.name = several->name;
    for (const NamedForm& form : several->forms) {
        const FormulaRow& other = rowNamed(rows, form.row);
        k.forms.push_back({form.name, other.ours});
        if (several->sameUnit || other.name == row.name) k.forms.back().tolerance = other.tolerance;
    }
    return k;
}

// --- times

constexpr double kCpuSeconds = 2e-4, kGpuSeconds = 1e-3;  // of one timing, at least
constexpr int kTries = 9;                                 // of which a round keeps the least
constexpr double kResolvedNs = 0.05;                      // less cannot be told from nothing
constexpr int kMaxOutputs = 64;

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Called through a pointer that the compiler cannot follow, as the forms are.
void nothing(const float* x, float* y) { y[0] = x[0]; }
void (*volatile emptyForm)(const float*, float*) = nothing;
volatile float keptSum = 0;

// Seconds of `passes` over all inputs.
double cpuSeconds(const Kernel& kernel, void (*form)(const float*, float*), const std::vector<float>& x, int passes) {
    float y[kMaxOutputs] = {};
    float sum = 0;
    const size_t step = size_t(kernel.row.inputs);
    const auto start = std::chrono::steady_clock::now();
    for (int pass = 0; pass < passes; ++pass)
        for (size_t i = 0; i < x.size(); i += step) {
            form(&x[i], y);
            sum += y[0];
        }
    const double seconds = since(start);
    keptSum = sum;
    return seconds;
}

// The least of a few, so that another program's turn is not taken for work.
template <class Time>
double leastOf(int tries, Time&& time) {
    double least = time();
    for (int i = 1; i < tries; ++i) least = std::min(least, time());
    return least;
}

// Seconds by which a form takes longer than the empty one, tried in turn.
template <class Time, class Empty>
double secondsMore(Time&& time, Empty&& empty) {
    double nothing = std::numeric_limits<double>::infinity();
    const double least = leastOf(kTries, [&] {
        nothing = std::min(nothing, empty());
        return time();
    });
    return least - nothing;
}

int passesOf(const Kernel& kernel, const FormulaBody& body, const std::vector<float>& x) {
    int passes = 1;
    while (passes < 1 << 16 && leastOf(3, [&] { return cpuSeconds(kernel, body.single, x, passes); }) < kCpuSeconds)
        passes *= 2;
    return passes;
}

// First more inputs an invocation, then more invocations, then inputs again.
KernelGrid gridOf(KernelBench& bench, size_t form) {
    KernelGrid grid;
    while (grid.steps < 1 << 16 && leastOf(3, [&] { return bench.seconds(form, grid); }) < kGpuSeconds) {
        if (grid.steps < 16 || grid.groups >= kMaxKernelGroups)
            grid.steps *= 2;
        else
            grid.groups *= 2;
    }
    return grid;
}

KernelTime timeOf(std::vector<double> ns) {
    KernelTime t;
    if (ns.empty()) return t;
    t.ns = std::max(quantileOf(ns, 0.5), 0.0);
    t.spread = 0.5 * (quantileOf(ns, 0.75) - quantileOf(ns, 0.25));
    return t;
}

struct FormRuns {
    int passes = 1;
    KernelGrid grid;
    std::vector<double> cpu, shader;  // ns of an evaluation, by round
};

void timeForms(const Kernel& kernel, KernelBench* bench, int rounds, std::vector<FormRuns>& runs) {
    const std::vector<float> x(kernel.samples.x.begin(), kernel.samples.x.end());
    for (size_t f = 0; f < runs.size(); ++f) {
        runs[f].passes = passesOf(kernel, kernel.forms[f].body, x);
        if (bench) runs[f].grid = gridOf(*bench, f);
    }
    for (int round = 0; round < rounds; ++round)
        for (size_t f = 0; f < runs.size(); ++f) {
            FormRuns& r = runs[f];
            const auto cpu = [&](void (*form)(const float*, float*)) {
                return [&, form] { return cpuSeconds(kernel, form, x, r.passes); };
            };
            r.cpu.push_back(secondsMore(cpu(kernel.forms[f].body.single), cpu(emptyForm)) * 1e9 /
                            (double(r.passes) * kernel.samples.count));
            if (!bench) continue;
            r.shader.push_back(
                secondsMore([&] { return bench->seconds(f, r.grid); }, [&] { return bench->emptySeconds(r.grid); }) *
                1e9 / r.grid.evaluations());
        }
}

void compareTimes(std::vector<KernelRow>& rows, KernelTime KernelRow::*member) {
    const KernelTime* cheapest = nullptr;
    for (const KernelRow& r : rows)
        if (!cheapest || (r.*member).ns < cheapest->ns) cheapest = &(r.*member);
    const double least = cheapest->ns;
    if (!(least > std::max(cheapest->spread, kResolvedNs))) return;
    for (KernelRow& r : rows) (r.*member).times = (r.*member).ns / least;
}

Result<std::vector<KernelRow>> measureKernel(const Kernel& kernel, int rounds, Gpu* gpu) {
    std::unique_ptr<KernelBench> bench;
    if (gpu) {
        auto made = KernelBench::make(*gpu, kernel);
        if (!made) return made.error();
        bench = std::make_unique<KernelBench>(std::move(*made));
    }
    std::vector<KernelRow> rows;
    for (size_t f = 0; f < kernel.forms.size(); ++f) {
        const KernelForm& form = kernel.forms[f];
        KernelRow row;
        row.id = kernel.row.id, row.formula = kernel.row.name, row.form = form.name;
        row.inputs = kernel.samples.count, row.tolerance = form.tolerance;
        row.cpu = kernelError(kernel, runSingle(kernel.row, form.body, kernel.samples));
        if (bench) row.shader = kernelError(kernel, bench->outputs(f));
        rows.push_back(row);
    }
    std::vector<FormRuns> runs(rows.size());
    timeForms(kernel, bench.get(), rounds, runs);
    for (size_t f = 0; f < rows.size(); ++f)
        rows[f].cpuTime = timeOf(runs[f].cpu), rows[f].shaderTime = timeOf(runs[f].shader);
    compareTimes(rows, &KernelRow::cpuTime);
    compareTimes(rows, &KernelRow::shaderTime);
    return rows;
}

}  // namespace

std::vector<Kernel> kernels(const ExpectedValues& values) {
    const std::vector<FormulaRow> rows = formulaRows();
    std::vector<Kernel> all;
    for (const FormulaRow& row : rows)
        if (row.published && !isFormOfAnother(row)) all.push_back(kernelOf(row, rows, values));
    return all;
}

KernelError kernelError(const Kernel& kernel, const std::vector<double>& outputs) {
    KernelError e;
    const FormulaSamples& s = kernel.samples;
    const size_t inputs = size_t(kernel.row.inputs), each = size_t(kernel.row.outputs);
    int finite = 0;
    for (size_t i = 0; i < size_t(s.count); ++i) {
        double worst = 0;
        bool fails = false;
        for (size_t k = i * each; k < (i + 1) * each; ++k) {
            if (std::isnan(s.want[k]) || outputs[k] == s.want[k]) continue;
            fails = fails || !std::isfinite(outputs[k]);
            worst = std::max(worst, kernel.row.error ? kernel.row.error(outputs[k], s.want[k], s.scale[k])
                                                     : std::abs(outputs[k] - s.want[k]) / s.scale[k]);
        }
        const auto input = [&] {
            return std::vector<double>(s.x.begin() + ptrdiff_t(i * inputs), s.x.begin() + ptrdiff_t((i + 1) * inputs));
        };
        if (fails && e.notFinite++ == 0) e.fails = input();
        if (fails) continue;
        ++finite;
        if (worst > e.largest) e.largest = worst, e.at = input();
    }
    if (finite == 0) e.largest = std::numeric_limits<double>::quiet_NaN();
    return e;
}

Result<KernelRun> measureKernels(const KernelRequest& request, Gpu* gpu, const KernelProgress& progress) {
    const auto values = loadExpectedValues(expectedValuesFile());
    if (!values) return values.error();
    KernelRun run;
    run.rounds = request.rounds;
    if (gpu) run.renderer = gpu->renderer;
    const std::vector<Kernel> all = kernels(*values);
    for (size_t i = 0; i < all.size(); ++i) {
        if (!progress(all[i].row.name, double(i) / double(all.size())))
            return interruption("interrupted; nothing was written");
        if (all[i].row.name.find(request.only) == std::string::npos) continue;
        auto rows = measureKernel(all[i], request.rounds, gpu);
        if (!rows) return rows.error();
        run.rows.insert(run.rows.end(), rows->begin(), rows->end());
    }
    return run;
}

}  // namespace sward
