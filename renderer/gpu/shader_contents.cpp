#include "renderer/gpu/shader_contents.h"

namespace unghost {
namespace {

// Of the SPIR-V specification, unified 1, section 3.
enum Opcode : uint32_t {
  ext_inst = 12,
  load = 61,
  decorate = 71,
  first_read = 87, // sampling, fetching, gathering and loading lie beside one another
  last_read = 98,
  image_write = 99,
  image_of_sampled = 100,
};
constexpr uint32_t binding = 33, header_words = 5;

} // namespace

int ShaderContents::fetches() const {
  int sum = 0;
  for (const auto& [slot, count] : reads) sum += count;
  return sum;
}

ShaderContents contents_of(std::span<const uint32_t> spirv) {
  ShaderContents contents;
  std::map<uint32_t, uint32_t> binding_of, image_of; // by variable; the variable that a value was loaded from
  for (size_t at = header_words; at < spirv.size(); at += spirv[at] >> 16) {
    const uint32_t opcode = spirv[at] & 0xffff;
    const std::span<const uint32_t> operand = spirv.subspan(at + 1);
    ++contents.instructions;
    if (opcode == decorate && operand[1] == binding) binding_of[operand[0]] = operand[2];
    if (opcode == load) image_of[operand[1]] = operand[2];
    if (opcode == image_of_sampled) image_of[operand[1]] = image_of[operand[2]];
    if (opcode == ext_inst) ++contents.functions[operand[3]];
    if (opcode >= first_read && opcode <= last_read) ++contents.reads[binding_of[image_of[operand[2]]]];
    if (opcode == image_write) ++contents.writes[binding_of[image_of[operand[0]]]];
  }
  return contents;
}

} // namespace unghost
