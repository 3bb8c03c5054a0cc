// The parser says where a value stands: line and column of its first character and of what follows
// it. One edit at a time, and the text is parsed again after each.
#include "runtime/workbench/toml_edit.h"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <algorithm>

namespace aspect {
namespace {

// Columns count characters, not bytes.
std::size_t offset_of(std::string_view text, const toml::source_position& place) {
  std::size_t at = 0;
  for (toml::source_index line = 1; line < place.line; ++line) {
    at = text.find('\n', at);
    if (at == std::string_view::npos) return text.size();
    ++at;
  }
  for (toml::source_index column = 1; column < place.column && at < text.size(); ++column) do
      ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U);
  return at;
}

std::size_t line_start(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

// Behind its line break.
std::size_t line_end(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string_view::npos ? text.size() : end + 1;
}

std::string_view line_break(std::string_view text) {
  return text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
}

// Puts whole lines there.
void insert_lines(std::string& text, std::size_t at, std::string lines) {
  const std::string_view end = line_break(text);
  if (at > 0 && text[at - 1] != '\n') lines.insert(0, end);
  lines += end;
  text.insert(at, lines);
}

void add_table(std::string& text, const TomlEdit& edit) {
  const std::string_view end = line_break(text);
  insert_lines(text, text.size(),
               fmt::format("{}[{}]{}{} = {}", text.empty() ? std::string_view() : end, edit.table,
                           end, edit.key, *edit.value));
}

void add_inline(std::string& text, const toml::table& table, const TomlEdit& edit) {
  const std::size_t brace = offset_of(text, table.source().begin);
  if (brace >= text.size() || text[brace] != '{') return;
  text.insert(brace + 1,
              fmt::format(" {} = {}{}", edit.key, *edit.value, table.empty() ? " " : ","));
}

void add_key(std::string& text, const toml::table& table, const TomlEdit& edit) {
  if (table.is_inline()) return add_inline(text, table, edit);
  const std::size_t header = offset_of(text, table.source().begin);
  std::size_t at = line_end(text, header);
  for (const auto& [key, node] : table) {
    // Tables of its own come later in the file.
    if (edit.first || (node.is_table() && !node.as_table()->is_inline()) ||
        node.is_array_of_tables())
      continue;
    at = std::max(at, line_end(text, offset_of(text, node.source().end)));
  }
  insert_lines(text, at, fmt::format("{} = {}", edit.key, *edit.value));
}

void take_out(std::string& text, const toml::node& node) {
  const std::size_t begin = offset_of(text, node.source().begin);
  const std::size_t end = offset_of(text, node.source().end);
  const std::size_t from = line_start(text, begin);
  text.erase(from, line_end(text, end) - from);
}

void edit_once(std::string& text, const toml::table& root, const TomlEdit& edit) {
  const toml::node* found = root.at_path(edit.table).node();
  const toml::table* table = found == nullptr ? nullptr : found->as_table();
  const toml::node* node = table == nullptr ? nullptr : table->get(edit.key);
  if (node != nullptr && edit.value) {
    const std::size_t begin = offset_of(text, node->source().begin);
    text.replace(begin, offset_of(text, node->source().end) - begin, *edit.value);
  } else if (node != nullptr) {
    take_out(text, *node);
  } else if (edit.value && table != nullptr) {
    add_key(text, *table, edit);
  } else if (edit.value) {
    add_table(text, edit);
  }
}

// What is to come out, without its text.
void apply(toml::table& root, const TomlEdit& edit) {
  toml::table* table = &root;
  for (std::string_view rest = edit.table; !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find('.'));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    toml::table* inner = (*table)[part].as_table();
    if (inner == nullptr) {
      if (!edit.value) return;
      inner = table->insert_or_assign(part, toml::table{}).first->second.as_table();
    }
    table = inner;
  }
  if (!edit.value) {
    table->erase(edit.key);
    return;
  }
  const toml::table value = toml::parse("value = " + *edit.value);
  table->insert_or_assign(edit.key, *value.get("value"));
}

Error cannot_edit(const std::string& name, std::span<const TomlEdit> edits) {
  std::string lines;
  for (const TomlEdit& edit : edits)
    lines += edit.value ? fmt::format(" [{}] {} = {};", edit.table, edit.key, *edit.value)
                        : fmt::format(" [{}] without {};", edit.table, edit.key);
  if (!lines.empty()) lines.pop_back();
  return {
      fmt::format("{}: is written so that it cannot be changed without losing comments; write "
                  "by hand:{}",
                  name, lines)};
}

}  // namespace

Result<std::string> edited_toml(std::string text, const std::string& name,
                                std::span<const TomlEdit> edits) {
  try {
    toml::table wanted = toml::parse(text, name);
    for (const TomlEdit& edit : edits) {
      edit_once(text, toml::parse(text, name), edit);
      apply(wanted, edit);
    }
    if (toml::parse(text, name) == wanted) return text;
  } catch (const toml::parse_error& error) {
    if (edits.empty())
      return Error{fmt::format("{}:{}: not TOML: {}; mend the line", name,
                               error.source().begin.line, error.description())};
  }
  return cannot_edit(name, edits);
}

}  // namespace aspect
