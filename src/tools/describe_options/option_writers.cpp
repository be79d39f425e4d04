#include "tools/describe_options/option_writers.h"

#include "options/option_texts.h"

namespace markerless_mocap {
namespace {

std::string allowedColumn(const OptionField& field) {
  return std::holds_alternative<double*>(field.value) ? rangeText(field) : allowedText(field);
}

}  // namespace

void YamlWriter::comment(const std::string& meaning) {
  if (meaning != last_meaning_) lines_ += indent_ + "# " + meaning + "\n";
  last_meaning_ = meaning;
}

void YamlWriter::visitField(const OptionField& field) {
  comment(field.meaning);
  lines_ += indent_ + field.key + ": " + valueText(field) + "\n";
}

void YamlWriter::visitSection(const char* key, const char* meaning, const Fields& fields) {
  comment(meaning);
  YamlWriter nested(indent_ + "  ");
  fields(nested);
  lines_ += indent_ + key + ":\n" + nested.lines();
}

TableWriter::TableWriter(std::string heading, std::string path, const std::string& text)
    : heading_(std::move(heading)), path_(std::move(path)) {
  own_ = "\n" + heading_ + path_ + "\n\n" + (text.empty() ? "" : text + "\n\n") +
         "| key | default | allowed | meaning |\n|---|---|---|---|\n";
}

void TableWriter::visitField(const OptionField& field) {
  own_ += "| `" + std::string(field.key) + "` | " + valueText(field) + " | " +
          allowedColumn(field) + " | " + field.meaning + " |\n";
}

void TableWriter::visitSection(const char* key, const char* meaning, const Fields& fields) {
  TableWriter nested("#" + heading_, path_ + "/" + key, meaning);
  fields(nested);
  sections_ += nested.page();
}

}  // namespace markerless_mocap
