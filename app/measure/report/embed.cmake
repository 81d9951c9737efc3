# Turns a file into object data: cmake -DIN=file -DOUT=source.cpp -DNAME=page_css -P embed.cmake. The source defines
# report_files::NAME of app/measure/report/embedded.h. Without IN, it is empty.
set(bytes "")
set(hash "")
if(IN)
  file(READ "${IN}" bytes HEX)
  file(SHA256 "${IN}" hash)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
endif()
file(WRITE "${OUT}" "#include \"app/measure/report/embedded.h\"

namespace unghost::report_files {
static constexpr unsigned char bytes[] = {
${bytes}0};
const EmbeddedFile ${NAME}{{reinterpret_cast<const char*>(bytes), sizeof bytes - 1}, \"${hash}\"};
} // namespace unghost::report_files
")
