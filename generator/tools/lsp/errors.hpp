// JSON-RPC 2.0, and LSP 3.17 "ErrorCodes".
#pragma once

namespace eagerx::gen::lsp {

inline constexpr int kParseError = -32700, kInvalidRequest = -32600, kMethodNotFound = -32601,
                     kInvalidParams = -32602, kServerNotInitialized = -32002;

}  // namespace eagerx::gen::lsp
