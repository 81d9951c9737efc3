#include "renderer/scene/gltf_folder.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "renderer/scene/gltf_report.h"

namespace unghost::gltf {

namespace {

constexpr int read_flags = O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

std::string reason(int error) { return std::strerror(error); }

std::vector<uint8_t> read_regular(int descriptor, uint64_t limit) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) throw FileProblem("cannot be read: " + reason(errno));
  if (!S_ISREG(status.st_mode)) throw FileProblem("is not a regular file");
  const auto size = uint64_t(status.st_size);
  if (size > limit) {
    throw FileProblem("has " + std::to_string(size) + " bytes; " + std::to_string(limit) + " are allowed");
  }
  std::vector<uint8_t> bytes(size);
  size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw FileProblem("cannot be read: " + reason(errno));
    if (got == 0) break; // it shrank meanwhile
    filled += size_t(got);
  }
  bytes.resize(filled);
  return bytes;
}

} // namespace

Folder::Folder(const std::filesystem::path& folder, const LoadLimits& limits, Confine confine)
    : folder_(folder.empty() ? "." : folder),
      descriptor_(open(folder_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)), file_bytes_(limits.file_bytes),
      bytes_left_(limits.read_bytes), confine_(confine) {
  if (descriptor_ < 0) throw FileProblem("its folder cannot be opened: " + reason(errno));
}

Folder::~Folder() { close(descriptor_); }

int Folder::open_beneath(const std::string& path, const std::string& pointer) const {
  if (confine_ == Confine::by_path) return open_by_path(path, pointer);
  open_how how{};
  how.flags = read_flags;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  const long opened = syscall(SYS_openat2, descriptor_, path.c_str(), &how, sizeof how);
  if (opened >= 0) return int(opened);
  // Sandboxes that do not know openat2 say EPERM.
  if (errno == ENOSYS || errno == EPERM) return open_by_path(path, pointer);
  if (errno == EXDEV) refuse("'" + printable(path) + "' leads out of the scene's folder", pointer);
  throw FileProblem(reason(errno));
}

int Folder::open_by_path(const std::string& path, const std::string& pointer) const {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path root = fs::canonical(folder_, error);
  const fs::path real = error ? fs::path() : fs::canonical(root / path, error);
  if (error) throw FileProblem(error.message());
  const auto [at, unused] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
  if (at != root.end()) refuse("'" + printable(path) + "' leads out of the scene's folder", pointer);
  const int opened = open(real.c_str(), read_flags | O_NOFOLLOW);
  if (opened < 0) throw FileProblem(reason(errno));
  return opened;
}

std::vector<uint8_t> Folder::read(const std::string& path, const std::string& pointer) {
  files_.push_back(folder_ / path);
  const Descriptor file{open_beneath(path, pointer)};
  std::vector<uint8_t> bytes = read_regular(file.number, std::min(file_bytes_, bytes_left_));
  bytes_left_ -= bytes.size();
  return bytes;
}

std::vector<uint8_t> read_file(const std::filesystem::path& path, uint64_t limit) {
  const Descriptor file{open(path.c_str(), read_flags)};
  if (file.number < 0) throw FileProblem("cannot be opened: " + reason(errno));
  return read_regular(file.number, limit);
}

} // namespace unghost::gltf
