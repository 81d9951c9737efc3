#include "app/demo/gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

namespace unghost {
namespace {

constexpr float usual_text_px = 13;

OwnedDescriptorPool make_descriptors(VkDevice device) {
  const VkDescriptorPoolSize font{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT,
                                        .maxSets = 1,
                                        .poolSizeCount = 1,
                                        .pPoolSizes = &font};
  VkDescriptorPool made = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device, &info, nullptr, &made), "making descriptors for the panel");
  return {device, made};
}

void check_backend(VkResult result) { check(result, "drawing the panel"); }

void set_style(double scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 2;
  style.WindowBorderSize = 0;
  style.Colors[ImGuiCol_WindowBg].w = 1; // the panel stands beside the picture, and nothing is below it
  style.Colors[ImGuiCol_TextDisabled] = {0.66f, 0.66f, 0.66f, 1}; // sentences are written in it, too
  style.ScaleAllSizes(float(scale));
}

} // namespace

Gui::Gui(Device& device, Swapchain& swapchain, GLFWwindow* window, double text_scale)
    : descriptors_(make_descriptors(device.handle())) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // what lasts is in the file of the demo
  ImFontConfig font;
  font.SizePixels = usual_text_px * float(text_scale);
  io.Fonts->AddFontDefault(&font);
  set_style(text_scale);
  ImGui_ImplGlfw_InitForVulkan(window, true);
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = device.instance();
  info.PhysicalDevice = device.physical();
  info.Device = device.handle();
  info.QueueFamily = device.queue_family();
  info.Queue = device.queue();
  info.DescriptorPool = descriptors_;
  info.MinImageCount = 2;
  info.ImageCount = std::max(swapchain.images(), 2u);
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check_backend;
  ImGui_ImplVulkan_Init(&info, swapchain.overlay_pass());
  device.run([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
  swapchain.overlay = [](VkCommandBuffer commands) {
    if (ImDrawData* drawn = ImGui::GetDrawData()) ImGui_ImplVulkan_RenderDrawData(drawn, commands);
  };
}

Gui::~Gui() {
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Gui::begin_frame() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Gui::end_frame() { ImGui::Render(); }
bool Gui::has_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Gui::has_keys() const { return ImGui::GetIO().WantTextInput; }

void Gui::window_changed(const Swapchain& swapchain) {
  ImGui_ImplVulkan_SetMinImageCount(std::max(swapchain.images(), 2u));
}

} // namespace unghost
