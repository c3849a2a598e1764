// The header of all classes of this library, which are never compiled.
#pragma once
