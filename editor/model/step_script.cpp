#include "model/step_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "model/field_walk.h"

namespace sward {
namespace {

const void* in(const FieldRow& f, const void* base) { return static_cast<const std::byte*>(base) + f.offset; }

template <class T>
std::string luaNumber(T v) {
    if (std::isinf(v)) return v > 0 ? "math.huge" : "-math.huge";
    return fmt::format("{}", v);
}

template <class V>
std::string luaVector(const V& v) {
    std::string out = "{ ";
    for (int i = 0; i < v.length(); ++i) out += (i ? ", " : "") + luaNumber(v[i]);
    return out + " }";
}

template <class T>
const T& as(const void* value) {
    return *static_cast<const T*>(value);
}

// The fields of a struct that differ from another's, maps left out; all that are no maps if there is no other.
std::string luaFields(std::span<const FieldRow> fields, const void* value, const void* other) {
    std::string out;
    for (const FieldRow& f : fields) {
        if (f.type == FieldType::Map) continue;
        if (other && sameFields({&f, 1}, value, other)) continue;
        out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", f.name, luaValue(f, in(f, value)));
    }
    return out.empty() ? "{}" : "{ " + out + " }";
}

std::string luaList(const ListRow& list, const void* value) {
    std::string out;
    for (size_t i = 0; i < list.size(value); ++i)
        out += (i ? ", " : "") + luaFields(list.fields, list.at(value, i), nullptr);
    return out.empty() ? "{}" : "{ " + out + " }";
}

// The one value that all texels of a map have.
std::optional<std::vector<float>> uniformValue(const Map& m) {
    const MapInfo& info = m.info();
    std::vector<float> value;
    for (int c = 0; c < info.channels; ++c) value.push_back(m.at(0, 0, c));
    const Tile* known = nullptr;
    for (int ty = 0; ty < m.tilesY(); ++ty)
        for (int tx = 0; tx < m.tilesX(); ++tx) {
            if (m.tile(tx, ty).get() == known) continue;
            known = m.tile(tx, ty).get();
            for (int y = ty * kTileSize; y < std::min((ty + 1) * kTileSize, info.height); ++y)
                for (int x = tx * kTileSize; x < std::min((tx + 1) * kTileSize, info.width); ++x)
                    for (int c = 0; c < info.channels; ++c)
                        if (m.at(x, y, c) != value[static_cast<size_t>(c)]) return {};
        }
    return value;
}

const char* typeName(PixelType t) { return t == PixelType::U8 ? "u8" : t == PixelType::U16 ? "u16" : "f32"; }

struct Writer {
    StepScript out;

    void set(const std::string& path, const std::string& value) {
        out.calls.push_back(fmt::format("entity.set({}, {})", luaText(path), value));
    }
    void noteFile(const FieldRow& f, const void* value) {
        if (f.isFile && !as<std::string>(value).empty()) out.files.push_back(as<std::string>(value));
    }
    // Heights of integers are metres in a script, and texels here.
    void map(const std::string& path, const FieldRow& f, const MapField& before, const MapField& after) {
        if (sameTexels(before.map, after.map)) return;
        if (!after.present()) return set(path, "nil");
        const MapInfo& info = after.map.info();
        const auto value = uniformValue(after.map);
        if (!value || (f.map->kind == MapKind::Heights && info.type != PixelType::F32)) {
            out.left.push_back("the texels of " + path);
            return;
        }
        std::string channels = luaNumber((*value)[0]);
        for (size_t c = 1; c < value->size(); ++c) channels += ", " + luaNumber((*value)[c]);
        out.calls.push_back(fmt::format(
            "map.create {{ path = {}, width = {}, height = {}, type = \"{}\", value = {} }}", luaText(path), info.width,
            info.height, typeName(info.type), value->size() == 1 ? channels : "{ " + channels + " }"));
    }
    void field(const std::string& path, const FieldRow& f, const void* before, const void* after) {
        if (f.type == FieldType::Map) return map(path, f, as<MapField>(before), as<MapField>(after));
        if (sameFields({&f, 1}, static_cast<const std::byte*>(before) - f.offset,
                       static_cast<const std::byte*>(after) - f.offset))
            return;
        if (f.type == FieldType::List) return list(path, *f.list, before, after);
        noteFile(f, after);
        set(path, luaValue(f, after));
    }
    void fields(const std::string& path, std::span<const FieldRow> rows, const void* before, const void* after) {
        for (const FieldRow& f : rows) field(path + "." + f.name, f, in(f, before), in(f, after));
    }

    // --- lists: an element that went, came at the end, or moved; else element by element
    static bool same(const ListRow& l, const void* a, size_t i, const void* b, size_t k) {
        return sameFields(l.fields, l.at(a, i), l.at(b, k));
    }
    void list(const std::string& path, const ListRow& l, const void* before, const void* after) {
        const size_t had = l.size(before), has = l.size(after);
        if (has + 1 == had) {
            size_t gone = 0;
            while (gone < has && same(l, before, gone, after, gone)) ++gone;
            bool rest = true;
            for (size_t i = gone; i < has; ++i) rest = rest && same(l, before, i + 1, after, i);
            if (rest) return out.calls.push_back(fmt::format("entity.removeElement({})", element(path, gone)));
        }
        if (has == had)
            if (const auto moved = movedElement(l, before, after))
                return out.calls.push_back(
                    fmt::format("entity.moveElement({}, {})", element(path, moved->first), moved->second));
        for (size_t n = had; n > has; --n)
            out.calls.push_back(fmt::format("entity.removeElement({})", element(path, n - 1)));
        for (size_t i = 0; i < std::min(had, has); ++i)
            fields(fmt::format("{}[{}]", path, i), l.fields, l.at(before, i), l.at(after, i));
        for (size_t i = had; i < has; ++i) addElement(path, l, after, i);
    }
    static std::string element(const std::string& path, size_t i) { return luaText(fmt::format("{}[{}]", path, i)); }
    // From where to where one element went, the others staying in order.
    static std::optional<std::pair<size_t, size_t>> movedElement(const ListRow& l, const void* before,
                                                                 const void* after) {
        const size_t n = l.size(before);
        size_t first = 0, last = n;
        while (first < n && same(l, before, first, after, first)) ++first;
        while (last > first && same(l, before, last - 1, after, last - 1)) --last;
        if (last < first + 2) return {};
        const auto shifted = [&](size_t by) {  // those between went one place back, or one forth
            for (size_t i = first; i + 1 < last; ++i)
                if (!same(l, before, i + by, after, i + 1 - by)) return false;
            return true;
        };
        if (shifted(1) && same(l, before, first, after, last - 1)) return std::pair{first, last - 1};
        if (shifted(0) && same(l, before, last - 1, after, first)) return std::pair{last - 1, first};
        return {};
    }
    // Its name is set even where it is the default: a new element gets one that is free.
    void addElement(const std::string& path, const ListRow& l, const void* list, size_t i) {
        const void* value = l.at(list, i);
        const std::string at = fmt::format("{}[{}]", path, i);
        out.calls.push_back(fmt::format("entity.addElement({})", luaText(path)));
        set(at + "." + l.fields[0].name, luaValue(l.fields[0], in(l.fields[0], value)));
        fields(at, l.fields.subspan(1), l.defaults(), value);
    }

    // --- components and entities
    void mapsOf(const std::string& path, std::span<const FieldRow> rows, const void* value) {
        for (const FieldRow& f : rows) {
            const void* v = in(f, value);
            if (f.type == FieldType::String) noteFile(f, v);
            if (f.type == FieldType::Map) map(path + "." + f.name, f, MapField{}, as<MapField>(v));
            if (f.type != FieldType::List) continue;
            for (size_t i = 0; i < f.list->size(v); ++i)
                mapsOf(fmt::format("{}.{}[{}]", path, f.name, i), f.list->fields, f.list->at(v, i));
        }
    }
    void component(const Change& c) {
        const std::string path = c.entity + "." + c.row->name;
        if (!c.after) {
            out.calls.push_back(fmt::format("entity.removeComponent({}, {})", luaText(c.entity), luaText(c.row->name)));
        } else if (!c.before) {
            set(path, luaFields(c.row->fields, c.after.get(), c.row->defaults()));
            mapsOf(path, c.row->fields, c.after.get());
        } else {
            fields(path, c.row->fields, c.before.get(), c.after.get());
        }
    }
};

bool goes(const UndoStep& step, const std::string& entity) {
    return std::any_of(step.changes.begin(), step.changes.end(),
                       [&](const Change& c) { return !c.row && !c.after && c.entity == entity; });
}

}  // namespace

std::string luaText(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 32)
            out += fmt::format("\\{:03}", static_cast<int>(c));
        else
            out += c;
    }
    return out + "\"";
}

std::string luaValue(const FieldRow& f, const void* value) {
    switch (f.type) {
        case FieldType::Bool:
            return as<bool>(value) ? "true" : "false";
        case FieldType::Int:
            return fmt::format("{}", as<int>(value));
        case FieldType::Float:
            return luaNumber(as<float>(value));
        case FieldType::Vec2:
            return luaVector(as<glm::dvec2>(value));
        case FieldType::Vec3:
            return luaVector(as<glm::dvec3>(value));
        case FieldType::Color:
            return luaVector(as<glm::vec3>(value));
        case FieldType::Enum:
            return luaText(f.options[static_cast<size_t>(enumIndex(value))]);
        case FieldType::String:
        case FieldType::Name:
            return luaText(as<std::string>(value));
        case FieldType::List:
            return luaList(*f.list, value);
        case FieldType::Map:
            break;
    }
    return "nil";
}

StepScript scriptOf(const UndoStep& step) {
    Writer w;
    for (const Change& c : step.changes)  // first those that come, so that others may name them
        if (!c.row && c.after) w.out.calls.push_back(fmt::format("entity.add({})", luaText(c.entity)));
    for (const Change& c : step.changes)
        if (c.row && !goes(step, c.entity)) w.component(c);
    for (const Change& c : step.changes)
        if (!c.row && !c.after) w.out.calls.push_back(fmt::format("entity.remove({})", luaText(c.entity)));
    return std::move(w.out);
}

}  // namespace sward
