#include <runtime/host/base/text_file.hpp>
#include <targets/linux-sim/table_writer.hpp>

namespace eagerx::linux_sim {

void TableWriter::text(std::string_view text) {
  file_.text(text);
}
void TableWriter::number(bool value) {
  file_.number(value);
}
void TableWriter::number(std::int8_t value) {
  file_.number(value);
}
void TableWriter::number(std::int16_t value) {
  file_.number(value);
}
void TableWriter::number(std::int32_t value) {
  file_.number(value);
}
void TableWriter::number(std::int64_t value) {
  file_.number(value);
}
void TableWriter::number(std::uint8_t value) {
  file_.number(value);
}
void TableWriter::number(std::uint16_t value) {
  file_.number(value);
}
void TableWriter::number(std::uint32_t value) {
  file_.number(value);
}
void TableWriter::number(std::uint64_t value) {
  file_.number(value);
}
void TableWriter::number(float value) {
  file_.number(value);
}
void TableWriter::number(double value) {
  file_.number(value);
}

}  // namespace eagerx::linux_sim
