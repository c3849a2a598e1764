# The extension as a .vsix, which VS Code installs: cmake [-D OUTPUT=FILE] -P pack.cmake
# A .vsix is a zip archive with two lists and the folder extension/. CMake makes it, so no npm and no network is needed.
cmake_minimum_required(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
file(READ ${here}/package.json package)
foreach(key name version publisher displayName description)
  string(JSON ${key} GET "${package}" ${key})
endforeach()
string(JSON engine GET "${package}" engines vscode)
string(JSON last LENGTH "${package}" files)
math(EXPR last "${last} - 1")
if(NOT OUTPUT)
  set(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}-${version}.vsix)
endif()
cmake_path(ABSOLUTE_PATH OUTPUT)

set(stage ${OUTPUT}.files)
file(REMOVE_RECURSE ${stage})
file(COPY ${here}/package.json DESTINATION ${stage}/extension)
foreach(i RANGE ${last})
  string(JSON file GET "${package}" files ${i})
  file(COPY ${here}/${file} DESTINATION ${stage}/extension)
endforeach()
file(COPY_FILE ${here}/../../../../LICENSE ${stage}/extension/LICENSE.txt)
file(WRITE "${stage}/[Content_Types].xml" [[
<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension="json" ContentType="application/json"/>
  <Default Extension="js" ContentType="application/javascript"/>
  <Default Extension="md" ContentType="text/markdown"/>
  <Default Extension="txt" ContentType="text/plain"/>
  <Default Extension="vsixmanifest" ContentType="text/xml"/>
</Types>
]])
file(WRITE ${stage}/extension.vsixmanifest "<?xml version=\"1.0\" encoding=\"utf-8\"?>
<PackageManifest Version=\"2.0.0\" xmlns=\"http://schemas.microsoft.com/developer/vsx-schema/2011\">
  <Metadata>
    <Identity Language=\"en-US\" Id=\"${name}\" Version=\"${version}\" Publisher=\"${publisher}\"/>
    <DisplayName>${displayName}</DisplayName>
    <Description xml:space=\"preserve\">${description}</Description>
    <Categories>Programming Languages,Linters</Categories>
    <Properties>
      <Property Id=\"Microsoft.VisualStudio.Code.Engine\" Value=\"${engine}\"/>
      <Property Id=\"Microsoft.VisualStudio.Code.ExtensionKind\" Value=\"workspace\"/>
    </Properties>
    <License>extension/LICENSE.txt</License>
  </Metadata>
  <Installation>
    <InstallationTarget Id=\"Microsoft.VisualStudio.Code\"/>
  </Installation>
  <Dependencies/>
  <Assets>
    <Asset Type=\"Microsoft.VisualStudio.Code.Manifest\" Path=\"extension/package.json\" Addressable=\"true\"/>
    <Asset Type=\"Microsoft.VisualStudio.Services.Content.Details\" Path=\"extension/README.md\" Addressable=\"true\"/>
    <Asset Type=\"Microsoft.VisualStudio.Services.Content.License\" Path=\"extension/LICENSE.txt\" Addressable=\"true\"/>
  </Assets>
</PackageManifest>
")
# The same files on every machine; the archive itself also says when each was read and changed, which CMake cannot leave
# out.
file(REMOVE ${OUTPUT})
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf ${OUTPUT} --format=zip --mtime=2024-01-01 "[Content_Types].xml" extension.vsixmanifest extension
                WORKING_DIRECTORY ${stage} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${stage})
message(STATUS "${OUTPUT}")
