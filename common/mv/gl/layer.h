// A listener over the function table: it hears of calls as they are made, and passes them on.
#pragma once
#include <type_traits>

#include "mv/gl/functions.h"

namespace mv {

// The functions, as variables of one object.
struct FunctionTable {
#define X(name, TYPE, version) PFNGL##TYPE##PROC name = nullptr;
#include "mv/gl/function_list.inc"
#undef X
};

// A Listener has members before_NAME or after_NAME, with the arguments of glNAME, for the functions it wants to hear of;
// the others are not touched. A member skip_NAME that returns true leaves the call out. There is one layer for each class
// of listeners, and one listener in it.
template <class Listener>
class Layer {
  public:
    // Lays the listener over what the table has now. For setLayer(), which does it again whenever the table is filled.
    static void layOver(Listener& listener) {
        listener_ = &listener;
#define X(name, TYPE, version)                                                              \
    below.name = gl##name;                                                                  \
    if constexpr (Told##name<PFNGL##TYPE##PROC>::heard) {                                   \
        if (below.name) gl##name = &Told##name<PFNGL##TYPE##PROC>::template call<Listener>; \
    }
#include "mv/gl/function_list.inc"
#undef X
    }

    // Takes it off again, where nothing was laid over it and the table was not filled since.
    static void takeOff() {
#define X(name, TYPE, version) gl##name = below.name;
#include "mv/gl/function_list.inc"
#undef X
        listener_ = nullptr;
    }

    // The functions under this layer: for a listener's own calls.
    inline static FunctionTable below;

    // While one lives, all gl* calls go past the layer, and past those over it.
    class Past {
      public:
        Past() {
#define X(name, TYPE, version) \
    kept_.name = gl##name;     \
    gl##name = below.name;
#include "mv/gl/function_list.inc"
#undef X
        }
        ~Past() {
#define X(name, TYPE, version) gl##name = kept_.name;
#include "mv/gl/function_list.inc"
#undef X
        }
        Past(const Past&) = delete;
        Past& operator=(const Past&) = delete;

      private:
        FunctionTable kept_;
    };

  private:
    inline static Listener* listener_ = nullptr;

#define X(name, TYPE, version)                                                                                 \
    template <class Function>                                                                                  \
    struct Told##name;                                                                                         \
    template <class Result, class... Arguments>                                                                \
    struct Told##name<Result (*)(Arguments...)> {                                                              \
        static constexpr bool hearsBefore = requires(Listener & l, Arguments... a) { l.before_##name(a...); }; \
        static constexpr bool hearsAfter = requires(Listener & l, Arguments... a) { l.after_##name(a...); };   \
        static constexpr bool skips = requires(Listener & l, Arguments... a) { l.skip_##name(a...); };         \
        static constexpr bool heard = hearsBefore || hearsAfter || skips;                                      \
        template <class Hearing>                                                                               \
        static Result call(Arguments... a) {                                                                   \
            Hearing& listener = *listener_;                                                                    \
            if constexpr (skips) {                                                                             \
                if (listener.skip_##name(a...)) return;                                                        \
            }                                                                                                  \
            if constexpr (hearsBefore) listener.before_##name(a...);                                           \
            if constexpr (std::is_void_v<Result>) {                                                            \
                below.name(a...);                                                                              \
                if constexpr (hearsAfter) listener.after_##name(a...);                                         \
            } else {                                                                                           \
                return below.name(a...);                                                                       \
            }                                                                                                  \
        }                                                                                                      \
    };
#include "mv/gl/function_list.inc"
#undef X
};

}  // namespace mv
