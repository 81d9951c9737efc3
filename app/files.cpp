#include "app/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/failure.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw Failure(Exit::failed, "cannot write " + path.string() + ": " + why);
}

// A link stays a link: what it points at is replaced.
fs::path behind_links(const fs::path& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

constexpr int most_at_once = 64; // processes that write the same file

fs::path beside(const fs::path& path, int number) {
  return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(number) + ".part");
}

bool lock(int descriptor) { return flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool is_named(int descriptor, const fs::path& name) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && lstat(name.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// Removes what a process that was killed left under a passing name. False where that is somebody's who still
/// writes: a lock ends with its process, on another machine, too.
bool remove_if_left(const fs::path& name) {
  const int left = open(name.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (left < 0) return errno == ENOENT;
  const bool nobodys = lock(left) && is_named(left, name) && unlink(name.c_str()) == 0;
  close(left);
  return nobodys;
}

/// Tries the passing names of `path` until `take` could have one: it returns 0, or an error, of which EEXIST
/// means that it is taken. Returns the name, or none and the error in errno.
template <class Take> fs::path passing_name(const fs::path& path, const Take& take) {
  for (int number = 0; number < most_at_once;) {
    fs::path name = beside(path, number);
    const int error = take(name);
    if (error == 0) return name;
    errno = error;
    if (error != EEXIST) return {};
    if (!remove_if_left(name)) ++number;
  }
  errno = EEXIST;
  return {};
}

/// Opens a new file of this name, locked. Returns 0 or the error.
int open_locked(const fs::path& name, int& descriptor) {
  descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  lock(descriptor); // where files cannot be locked, what is left stays
  if (is_named(descriptor, name)) return 0;
  close(descriptor); // between the two it was taken for one that was left
  descriptor = -1;
  return EEXIST;
}

} // namespace

NewFile::NewFile(fs::path path) : path_(behind_links(path)) {
  struct stat there {};
  const bool exists = stat(path_.c_str(), &there) == 0;
  if (path_.filename().empty() || (exists && S_ISDIR(there.st_mode))) cannot_write(path_, "it is a folder");
  if (exists && !S_ISREG(there.st_mode)) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    descriptor_ = open(folder_of(path_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    nameless_ = descriptor_ >= 0;
  }
  if (descriptor_ < 0 &&
      (errno == EOPNOTSUPP || errno == EISDIR)) { // files without a name are not known there
    passing_name_ =
        passing_name(path_, [this](const fs::path& name) { return open_locked(name, descriptor_); });
  }
  if (descriptor_ < 0) fail(errno);
}

NewFile::~NewFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!passing_name_.empty()) unlink(passing_name_.c_str());
}

void NewFile::fail(int error) const {
  const fs::path folder = path_.parent_path();
  std::error_code ignored;
  if (error == ENOENT && !folder.empty() && !fs::exists(folder, ignored))
    cannot_write(path_, "there is no folder " + folder.string());
  cannot_write(path_, error == ENOENT ? "its folder takes no files" : std::strerror(error));
}

void NewFile::write(std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes = bytes.subspan(size_t(written));
  }
}

void NewFile::commit() {
  if (nameless_) {
    lock(descriptor_);
    const std::string nameless = "/proc/self/fd/" + std::to_string(descriptor_);
    passing_name_ = passing_name(path_, [&](const fs::path& name) {
      return linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
    });
    if (passing_name_.empty()) fail(errno);
  }
  // a file system of a network may say only when it is closed that a disk is full; the lock stays for the
  // move
  const int again = dup(descriptor_);
  if (again < 0 || close(again) != 0) fail(errno);
  if (!passing_name_.empty() && std::rename(passing_name_.c_str(), path_.c_str()) != 0) fail(errno);
  passing_name_.clear();
}

std::filesystem::path free_name(const std::string& name, const std::string& extension) {
  std::error_code ignored;
  for (uint32_t number = 1;; ++number) {
    std::filesystem::path file = name + "-" + std::to_string(number) + extension;
    if (!std::filesystem::exists(file, ignored)) return file;
  }
}

void write_file(const fs::path& path, std::span<const uint8_t> bytes) {
  NewFile file(path);
  file.write(bytes);
  file.commit();
}

std::span<const uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Failure(Exit::failed, "cannot make the folder " + folder.string() + ": " + error.message());
}

void check_takes_files(const fs::path& folder) {
  NewFile(folder / "probe").write(std::vector<uint8_t>(1 << 20)); // and never gets its name
}

std::vector<uint8_t> read_file(const fs::path& path, size_t limit) {
  const auto refuse = [&](const std::string& why) {
    throw Failure(Exit::input_refused, "cannot read " + path.string() + ": " + why);
  };
  const int descriptor = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) refuse(std::strerror(errno));
  struct Closing {
    int descriptor;
    ~Closing() { close(descriptor); }
  } closing{descriptor};
  struct stat facts {};
  if (fstat(descriptor, &facts) != 0 || !S_ISREG(facts.st_mode)) refuse("it is no regular file");
  if (uint64_t(facts.st_size) > limit) refuse("it has more than " + std::to_string(limit) + " bytes");
  std::vector<uint8_t> bytes(size_t(facts.st_size));
  size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(std::strerror(errno));
    if (got == 0) break;
    filled += size_t(got);
  }
  bytes.resize(filled);
  return bytes;
}

} // namespace unghost
