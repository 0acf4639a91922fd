// Fields as Lua values, both ways: numbers, strings, booleans, {x, y, z}, lists of tables.
// Does not: change anything itself but through Document, so that all is one undo step and refused as anywhere else.
#pragma once
#include "script/state.h"

namespace sward::script {

// Pushes a field: a number, string, boolean, a table of numbers, a list of tables, or a map's file (nil if absent).
void pushField(lua_State* L, const FieldRow& field, const void* value);
// Pushes a struct as a table of its fields.
void pushFields(lua_State* L, std::span<const FieldRow> fields, const void* base);
// Sets what `path` names (a field, a list or a component) from the value at index. Raises, with the caller's group to
// be cancelled.
void setFromLua(lua_State* L, const std::string& path, const FieldRow& field, int index);
// Sets the fields of a struct from the table at index, in the order of their names.
void setFieldsFromLua(lua_State* L, const std::string& path, std::span<const FieldRow> fields, int index);
// A group of edits that is cancelled unless kept: when a call raises half-way, nothing of it stays.
class GroupOrNothing {
  public:
    GroupOrNothing(Document& d, const std::string& label) : document_(d) { d.beginGroup(label); }
    ~GroupOrNothing() {
        if (!kept_) document_.cancelGroup();
    }
    // The edits stay, as one undo step.
    void keep() {
        kept_ = true;
        document_.endGroup();
    }

  private:
    Document& document_;
    bool kept_ = false;
};

}  // namespace sward::script
