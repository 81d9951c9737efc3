#include "renderer/gpu/specialize.h"

#include <stdexcept>
#include <string>
#include <unordered_map>

#include <spirv-tools/optimizer.hpp>

namespace unghost {

std::vector<uint32_t> specialized(std::span<const uint32_t> spirv, std::span<const uint32_t> constants) {
  std::unordered_map<uint32_t, std::vector<uint32_t>> values;
  for (uint32_t id = 0; id < constants.size(); ++id) values[id] = {constants[id]};
  std::string error;
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
  optimizer.SetMessageConsumer(
      [&error](spv_message_level_t, const char*, const spv_position_t&, const char* text) { error = text; });
  const auto leave_out_unused = [&optimizer] {
    optimizer.RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass(false));
  };
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
      .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
  leave_out_unused(); // before the rest, which is then ten times less
  optimizer
      .RegisterPass(spvtools::CreateInlineExhaustivePass()) // what a function is asked becomes known
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass());
  leave_out_unused();
  spvtools::OptimizerOptions options;
  options.set_run_validator(false); // the validation layer has a look at each module
  std::vector<uint32_t> result;
  if (!optimizer.Run(spirv.data(), spirv.size(), &result, options))
    throw std::runtime_error("a shader cannot be specialized: " + error + "; build again");
  return result;
}

} // namespace unghost
