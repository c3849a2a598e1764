// Status codes of HTTP (RFC 9110, section 15).
#pragma once

namespace eagerx::gen::serve {

enum Status : int {
  kFine = 200,
  kBadRequest = 400,
  kForbidden = 403,
  kNotFound = 404,
  kWrongMethod = 405,
  kConflict = 409,
  kTooLarge = 413,
  kWrongType = 415,
  kImpossible = 422,
  kFailed = 500,
};

}  // namespace eagerx::gen::serve
