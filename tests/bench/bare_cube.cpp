// The cost of cube-cull without mvgl: a bare program that draws the same cube with the same two shaders, the same 36
// vertices and the same PNG settings, on the same host (OSMesa), and writes one 512x512 picture.
//     bare-cube VERTEX_SHADER FRAGMENT_SHADER PICTURE
#include <GL/glcorearb.h>
#include <dlfcn.h>
#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr int side = 512;

void* (*glAddress)(const char*) = nullptr;
template <class Function>
Function gl(const char* name) {
    return reinterpret_cast<Function>(glAddress(name));
}
#define GL(TYPE, name) const auto name = gl<PFNGL##TYPE##PROC>("gl" #name)

std::string shaderText(const char* path) {
    std::ifstream file(path);
    return "#version 330 core\n" + std::string(std::istreambuf_iterator<char>(file), {});
}

// 36 corners: position (3) and colour (4), the faces of the course's colour cube.
std::vector<float> cubeVertices() {
    const float corners[8][3] = {{-.5F, -.5F, .5F},  {-.5F, .5F, .5F},  {.5F, .5F, .5F},  {.5F, -.5F, .5F},
                                 {-.5F, -.5F, -.5F}, {-.5F, .5F, -.5F}, {.5F, .5F, -.5F}, {.5F, -.5F, -.5F}};
    const float colors[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const int faces[6][4] = {{1, 0, 3, 2}, {2, 3, 7, 6}, {3, 0, 4, 7}, {6, 5, 1, 2}, {4, 5, 6, 7}, {5, 4, 0, 1}};
    std::vector<float> values;
    for (const auto& face : faces) {
        for (const int i : {0, 1, 2, 0, 2, 3}) {
            values.insert(values.end(), corners[face[i]], corners[face[i]] + 3);
            values.insert(values.end(), colors[face[0]], colors[face[0]] + 3);
            values.push_back(1);
        }
    }
    return values;
}

int writePicture(const char* path, const std::vector<unsigned char>& rgba) {
    std::FILE* file = std::fopen(path, "wb");
    if (!file) return 1;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png))) return 1;
    png_init_io(png, file);
    png_set_compression_level(png, 1);
    png_set_filter(png, 0, PNG_FILTER_SUB);
    png_set_IHDR(png, info, side, side, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    for (int y = side - 1; y >= 0; --y) {
        png_write_row(png, rgba.data() + static_cast<std::size_t>(y) * side * 4);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return std::fclose(file) == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 4) return 2;
    void* mesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!mesa) return 1;
    const auto create = reinterpret_cast<void* (*)(const int*, void*)>(dlsym(mesa, "OSMesaCreateContextAttribs"));
    const auto current =
        reinterpret_cast<GLboolean (*)(void*, void*, GLenum, GLsizei, GLsizei)>(dlsym(mesa, "OSMesaMakeCurrent"));
    glAddress = reinterpret_cast<void* (*)(const char*)>(dlsym(mesa, "OSMesaGetProcAddress"));
    const int attributes[] = {0x22, GL_RGBA, 0x30, 0, 0x31, 0, 0x33, 0x34, 0x36, 3, 0x37, 3, 0};
    void* context = create(attributes, nullptr);
    std::vector<unsigned char> own(4 * 4 * 4);
    if (!context || !current(context, own.data(), GL_UNSIGNED_BYTE, 4, 4)) return 1;

    GL(GENFRAMEBUFFERS, GenFramebuffers);
    GL(BINDFRAMEBUFFER, BindFramebuffer);
    GL(GENRENDERBUFFERS, GenRenderbuffers);
    GL(BINDRENDERBUFFER, BindRenderbuffer);
    GL(RENDERBUFFERSTORAGE, RenderbufferStorage);
    GL(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer);
    GLuint framebuffer = 0, buffers[2] = {0, 0};
    GenFramebuffers(1, &framebuffer);
    BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    GenRenderbuffers(2, buffers);
    BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, side, side);
    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, side, side);
    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);

    GL(CREATESHADER, CreateShader);
    GL(SHADERSOURCE, ShaderSource);
    GL(COMPILESHADER, CompileShader);
    GL(CREATEPROGRAM, CreateProgram);
    GL(ATTACHSHADER, AttachShader);
    GL(BINDATTRIBLOCATION, BindAttribLocation);
    GL(LINKPROGRAM, LinkProgram);
    GL(GETPROGRAMIV, GetProgramiv);
    GL(USEPROGRAM, UseProgram);
    const GLuint program = CreateProgram();
    const GLenum kinds[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    for (int i = 0; i < 2; ++i) {
        const std::string text = shaderText(arguments[1 + i]);
        const char* pointer = text.c_str();
        const GLuint shader = CreateShader(kinds[i]);
        ShaderSource(shader, 1, &pointer, nullptr);
        CompileShader(shader);
        AttachShader(program, shader);
    }
    BindAttribLocation(program, 0, "position");
    BindAttribLocation(program, 2, "color");
    LinkProgram(program);
    GLint linked = GL_FALSE;
    GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) return 1;
    UseProgram(program);

    GL(GENVERTEXARRAYS, GenVertexArrays);
    GL(BINDVERTEXARRAY, BindVertexArray);
    GL(GENBUFFERS, GenBuffers);
    GL(BINDBUFFER, BindBuffer);
    GL(BUFFERDATA, BufferData);
    GL(VERTEXATTRIBPOINTER, VertexAttribPointer);
    GL(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray);
    const std::vector<float> vertices = cubeVertices();
    GLuint vertexArray = 0, vertexBuffer = 0;
    GenVertexArrays(1, &vertexArray);
    BindVertexArray(vertexArray);
    GenBuffers(1, &vertexBuffer);
    BindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
    BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)), vertices.data(),
               GL_STATIC_DRAW);
    VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 28, nullptr);
    VertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, 28, reinterpret_cast<const void*>(12));
    EnableVertexAttribArray(0);
    EnableVertexAttribArray(2);

    GL(VIEWPORT, Viewport);
    GL(CLEARCOLOR, ClearColor);
    GL(CLEAR, Clear);
    GL(ENABLE, Enable);
    GL(GETUNIFORMLOCATION, GetUniformLocation);
    GL(UNIFORMMATRIX4FV, UniformMatrix4fv);
    GL(DRAWARRAYS, DrawArrays);
    GL(READPIXELS, ReadPixels);
    const float view[16] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -4, 1};
    const float clip[16] = {2.1445069F, 0, 0, 0, 0, 2.1445069F, 0, 0, 0, 0, -1.004008F, -1, 0, 0, -0.4008016F, 0};
    Viewport(0, 0, side, side);
    ClearColor(0.9F, 1, 1, 1);
    Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    Enable(GL_DEPTH_TEST);
    Enable(GL_CULL_FACE);
    UniformMatrix4fv(GetUniformLocation(program, "viewFromModel"), 1, GL_FALSE, view);
    UniformMatrix4fv(GetUniformLocation(program, "clipFromView"), 1, GL_FALSE, clip);
    DrawArrays(GL_TRIANGLES, 0, 36);
    std::vector<unsigned char> rgba(static_cast<std::size_t>(side) * side * 4);
    ReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return writePicture(arguments[3], rgba);
}
