// The line: trained, read, written, judged and applied.
#include "module.hpp"
#include "snapshots.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/runtime/surface/shipped_classifier.hpp>

#include <algorithm>

namespace meniscus {
namespace {

using namespace py::literals;
using Path = std::filesystem::path;

/// A labelled state, in memory or, where it has a path, in a file.
struct StateSource {
    std::optional<Path> file;
    Snapshot snapshot;
    std::string name; ///< for messages
};

std::vector<StateSource> state_sources(const py::iterable& states) {
    std::vector<StateSource> sources;
    for (const py::handle state : states) {
        StateSource source;
        if (py::hasattr(state, "positions")) {
            source.snapshot = snapshot_from_python(state);
            source.name = "state " + std::to_string(sources.size());
        } else {
            source.file = state.cast<Path>();
        }
        sources.push_back(std::move(source));
    }
    return sources;
}

std::vector<LabelledState> labelled_states(const std::vector<StateSource>& sources,
                                           const std::string& scene, const FeaturePair& features) {
    std::vector<LabelledState> states;
    for (const StateSource& source : sources) {
        if (source.file)
            states.push_back(read_labelled_state(*source.file, scene, features));
        else
            states.push_back(labelled_state(source.snapshot, source.name, features));
        if (!scene.empty())
            states.back().scene = scene;
    }
    return states;
}

FeaturePair pair_of(const std::vector<std::string>& names, const FeaturePair& otherwise) {
    return names.empty() ? otherwise : feature_pair(names);
}

Model train_line(const py::iterable& states, const TrainingOptions& options,
                 const std::vector<std::string>& features,
                 const std::vector<std::string>& second_features, const std::string& scene) {
    const auto sources = state_sources(states);
    const py::gil_scoped_release released;
    const std::lock_guard<std::mutex> alone(file_access());
    const auto usual = options.keep_k ? options.keep_k->features : FeaturePair{};
    const auto first = labelled_states(sources, scene, pair_of(features, usual));
    Model model = train(first, options);
    if (!second_features.empty())
        add_second_line(model, first,
                        labelled_states(sources, scene, feature_pair(second_features)));
    return model;
}

TrainingOptions training_options(const py::dict& given) {
    TrainingOptions options;
    options.objective = given["objective"].cast<std::string>();
    options.label_threshold = given["label_threshold"].cast<double>();
    options.seed = given["seed"].cast<std::uint64_t>();
    if (const py::object kept = given["keep_k"]; !kept.is_none())
        options.keep_k = kept.cast<Model>();
    return options;
}

AuditRow& row_of(const std::string& scene, std::vector<AuditRow>& rows) {
    for (AuditRow& row : rows)
        if (row.scene == scene)
            return row;
    rows.emplace_back();
    rows.back().scene = scene;
    return rows.back();
}

/// As the audit of files, for snapshots in memory.
AuditReport audit_snapshots(const Model& model, const std::vector<StateSource>& sources,
                            const AuditOptions& options) {
    AuditReport report;
    report.model = model;
    report.label_threshold = options.label_threshold.value_or(model.label_threshold);
    report.total.scene = "all";
    std::vector<ModelUse> uses;
    for (const StateSource& source : sources) {
        LabelledState state = labelled_state(source.snapshot, source.name);
        if (!options.scene.empty())
            state.scene = options.scene;
        AuditRow row =
            audit_state(model, source.snapshot, state, report.label_threshold, options.threads);
        row.scene = state.scene;
        add_row(row, row_of(state.scene, report.scenes));
        add_row(row, report.total);
        uses.push_back({state.file, state.spacing_ratio, bulk_neighbor_count(state)});
    }
    const std::string warning = outside_trained_range(model, uses);
    if (!warning.empty())
        report.warnings.push_back(warning);
    return report;
}

/// The report as JSON.
std::string audit_line(const Model& model, const py::iterable& states, double label_threshold,
                       const std::string& scene, int threads) {
    const auto sources = state_sources(states);
    const py::gil_scoped_release released;
    const std::lock_guard<std::mutex> alone(file_access());
    const AuditOptions options{label_threshold, scene, threads};
    std::vector<Path> files;
    for (const StateSource& source : sources)
        if (source.file)
            files.push_back(*source.file);
    if (files.size() == sources.size())
        return to_json(audit(model, files, options));
    if (!files.empty())
        throw InputError("audit takes files or snapshots, found both");
    return to_json(audit_snapshots(model, sources, options));
}

/// Of models in the order of the ratios that they are for, the place of the one whose line the
/// runtime has at this ratio. Throws InputError as the runtime does, and where none is.
std::size_t shipped_place(const std::vector<Model>& models, int dimension, double spacing_ratio) {
    const SurfaceLine<double> line = shipped_first_line(dimension, spacing_ratio);
    SurfaceTensionOptions options;
    options.spacing_ratio = std::max(spacing_ratio, models.at(0).spacing_ratio.value().min);
    for (std::size_t place = 0; place < models.size(); ++place) {
        set_classifier(options, models[place]);
        // The compiled lines and those of files may be scaled with another rounding.
        if (std::abs(options.k - line.k) <= 1e-9 * std::abs(line.k) &&
            std::abs(options.d - line.d) <= 1e-9 * std::abs(line.d))
            return place;
    }
    throw InputError("the models that come with the module are not those it was built with; "
                     "install it again");
}

py::dict classify_state(const py::object& object, const Model& model, bool skip_invalid,
                        int threads) {
    const Snapshot snapshot = snapshot_from_python(object);
    Classes classes = [&] {
        const py::gil_scoped_release released;
        return classify_snapshot(snapshot, model, {skip_invalid, threads});
    }();
    return py::dict("surface"_a = array_of(std::move(classes.surface)),
                    "valid"_a = array_of(std::move(classes.valid)),
                    "neighbor_count"_a = array_of(std::move(classes.neighbor_count)),
                    "spacing_ratio"_a = classes.neighborhoods.spacing_ratio,
                    "warnings"_a = classes.warnings);
}

py::tuple names_of_pair(const FeaturePair& pair) {
    return py::make_tuple(feature_list[pair.first].name, feature_list[pair.second].name);
}

py::object range_tuple(const std::optional<Range>& range) {
    if (!range)
        return py::none();
    return py::make_tuple(range->min, range->max);
}

py::object second_line(const Model& model) {
    if (!model.second)
        return py::none();
    const SecondModelLine& second = *model.second;
    return py::dict("k"_a = second.line.k, "d"_a = second.line.d,
                    "features"_a = names_of_pair(second.features),
                    "surface_above"_a = second.line.above);
}

Model with_line(Model model, double k, double d) {
    model.line.k = k;
    model.line.d = d;
    return model_from_json(model_to_json(model), model.file); // checks both
}

std::string text_of(const Model& model) {
    std::string text = line_text(model.line, model.features, 5);
    if (model.second)
        text += "; of these " + line_text(model.second->line, model.second->features, 5);
    return text;
}

void add_model(py::module_& module) {
    py::class_<Model> model(module, "Model");
    model.def_property_readonly("k", [](const Model& self) { return self.line.k; })
        .def_property_readonly("d", [](const Model& self) { return self.line.d; })
        .def_property_readonly("surface_above", [](const Model& self) { return self.line.above; })
        .def_property_readonly("features",
                               [](const Model& self) { return names_of_pair(self.features); })
        .def_property_readonly("second_line", second_line)
        .def_property_readonly("spacing_ratio",
                               [](const Model& self) { return range_tuple(self.spacing_ratio); })
        .def_readonly("dimension", &Model::dimension)
        .def_readonly("radius_ratio", &Model::radius_ratio)
        .def_readonly("label_threshold", &Model::label_threshold)
        .def_readonly("boundary_weight", &Model::boundary_weight)
        .def_readonly("objective", &Model::objective)
        .def_readonly("false_negatives", &Model::false_negatives)
        .def_readonly("false_positives", &Model::false_positives)
        .def("__str__", text_of)
        .def("to_json", model_to_json)
        .def("header", [](const Model& self, const std::string& name) {
            return coefficient_header(self, name);
        });
}

} // namespace

void add_lines(py::module_& module) {
    add_model(module);
    module.def("read_model", [](const Path& file) { return read_model(file); });
    module.def("write_whole",
               [](const Path& file, const std::string& text) { write_whole(file, text); });
    module.def("train", [](const py::iterable& states, const py::dict& given,
                           const std::vector<std::string>& features,
                           const std::vector<std::string>& second_features,
                           const std::string& scene) {
        return train_line(states, training_options(given), features, second_features, scene);
    });
    module.def("with_line", with_line);
    module.def("audit", audit_line);
    module.def("shipped_place", shipped_place);
    module.def("classify", classify_state);
}

} // namespace meniscus
