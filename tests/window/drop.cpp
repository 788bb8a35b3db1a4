// drop WINDOW FILE...: drops files onto a window, as a file manager does (the XDND protocol, version 5). Nothing but the protocol
// takes part: no button is pressed. Status 0 once the window says that it has them.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

std::string uriOf(const std::filesystem::path& file) {
    std::string uri = "file://";
    for (const char c : std::filesystem::absolute(file).string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           std::string("/-_.").find(c) != std::string::npos;
        constexpr const char* digits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        uri += plain ? std::string(1, c) : std::string{'%', digits[byte / 16], digits[byte % 16]};
    }
    return uri + "\r\n";
}

class Source {
  public:
    Source(Display* display, Window target, std::string uris)
        : display_(display), target_(target), uris_(std::move(uris)) {
        self_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), self_, CurrentTime);
    }
    // Whether the window took them.
    bool drop() {
        const long list = static_cast<long>(atom("text/uri-list"));
        tell("XdndEnter", 5L << 24, list, 0, 0);
        tell("XdndPosition", 0, 0, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        bool dropped = false;
        for (;;) {
            XEvent event{};
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) give(event.xselectionrequest);
            if (event.type != ClientMessage) continue;
            const XClientMessageEvent& said = event.xclient;
            if (said.message_type == atom("XdndStatus")) {
                if ((said.data.l[1] & 1) == 0) return false;  // it wants none
                if (!dropped) tell("XdndDrop", 0, CurrentTime, 0, 0);
                dropped = true;
            }
            // (GLFW 3.3 answers with the number of bytes, in the place of 1.)
            if (said.message_type == atom("XdndFinished")) return said.data.l[1] != 0;
        }
    }

  private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }
    void tell(const char* what, long a, long b, long c, long d) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display_;
        event.xclient.window = target_;
        event.xclient.message_type = atom(what);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(self_);
        const long rest[] = {a, b, c, d};
        for (int i = 0; i < 4; ++i) event.xclient.data.l[i + 1] = rest[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }
    void give(const XSelectionRequestEvent& asked) const {
        XChangeProperty(display_, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uris_.data()), static_cast<int>(uris_.size()));
        XEvent answer{};
        answer.xselection.type = SelectionNotify;
        answer.xselection.requestor = asked.requestor;
        answer.xselection.selection = asked.selection;
        answer.xselection.target = asked.target;
        answer.xselection.property = asked.property;
        answer.xselection.time = asked.time;
        XSendEvent(display_, asked.requestor, False, NoEventMask, &answer);
        XFlush(display_);
    }

    Display* display_;
    Window target_, self_ = 0;
    std::string uris_;
};

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::cerr << "drop: must have a window and files\n";
        return 2;
    }
    Display* display = XOpenDisplay(nullptr);
    if (!display) return 1;
    std::string uris;
    for (int i = 2; i < count; ++i) uris += uriOf(arguments[i]);
    const bool taken = Source(display, std::strtoul(arguments[1], nullptr, 0), uris).drop();
    XCloseDisplay(display);
    return taken ? 0 : 1;
}
