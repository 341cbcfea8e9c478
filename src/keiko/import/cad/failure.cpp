#include "keiko/import/cad/failure.h"

#include "keiko/base/error.h"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <algorithm>
#include <new>

namespace keiko::cad {

std::string current_failure() {
    std::string text;
    try {
        throw;
    } catch (const Error& e) {
        text = e.reason();
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure& e) {
        const std::string message = e.GetMessageString() ? e.GetMessageString() : "";
        text = std::string("OpenCASCADE: ") + e.DynamicType()->Name() +
               (message.empty() ? "" : ": " + message);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        text = e.what();
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace keiko::cad
