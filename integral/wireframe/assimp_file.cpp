// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/mesh_file.h"

#include "integral/base/file_bytes.h"
#include "integral/frame/encoding.h"

#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <csignal>
#include <cstring>
#include <optional>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace integral {
namespace {

constexpr rlim_t most_memory = rlim_t(4) << 30; ///< bytes
constexpr rlim_t most_seconds = 120;            ///< of processor time

/// Adds the objects of an Assimp scene to a mesh.
class SceneTaker {
public:
    SceneTaker(const aiScene& scene, const MeshReading& how, bool linear)
        : scene_(scene), how_(how), linear_(linear)
    {
    }

    Mesh take()
    {
        take_node(*scene_.mRootNode, aiMatrix4x4());
        if (mesh_.points.empty() && mesh_.lines.empty() && mesh_.triangles.empty())
            throw std::runtime_error("it has no vertices");
        keep_each_edge_once(mesh_);
        return std::move(mesh_);
    }

private:
    void take_node(const aiNode& node, const aiMatrix4x4& outer)
    {
        const aiMatrix4x4 place = outer * node.mTransformation;
        for (unsigned k = 0; k < node.mNumMeshes; ++k)
            take_mesh(*scene_.mMeshes[node.mMeshes[k]], place);
        for (unsigned k = 0; k < node.mNumChildren; ++k)
            take_node(*node.mChildren[k], place);
    }

    void take_mesh(const aiMesh& from, const aiMatrix4x4& place)
    {
        const std::size_t first = mesh_.vertices.size();
        if (first + from.mNumVertices > UINT32_MAX)
            throw std::runtime_error("it has more than 4294967295 vertices");
        for (unsigned k = 0; k < from.mNumVertices; ++k) {
            const aiVector3D v = place * from.mVertices[k];
            if (!(std::fabs(v.x) <= 1e30f && std::fabs(v.y) <= 1e30f && std::fabs(v.z) <= 1e30f))
                throw std::runtime_error("a vertex's coordinates are no numbers below 1e30");
            mesh_.vertices.push_back({v.x, v.y, v.z});
        }
        const Colour material = colour_of_material(from);
        for (unsigned k = 0; k < from.mNumFaces; ++k)
            take_face(from, from.mFaces[k], std::uint32_t(first), material);
        if (from.mNumFaces == 0) // a cloud of points
            for (unsigned k = 0; k < from.mNumVertices; ++k)
                mesh_.points.push_back(
                    {std::uint32_t(first) + k, colour_of(from, k).value_or(material)});
    }

    /// The colour of a vertex, if the file gives it one.
    std::optional<Colour> colour_of(const aiMesh& from, unsigned vertex) const
    {
        const aiColor4D* colours = how_.ignore_colours ? nullptr : from.mColors[0];
        return colours ? std::optional(light_of(colours[vertex])) : std::nullopt;
    }

    Colour colour_of_material(const aiMesh& from) const
    {
        if (how_.ignore_colours || from.mMaterialIndex >= scene_.mNumMaterials)
            return how_.plain;
        const aiMaterial& material = *scene_.mMaterials[from.mMaterialIndex];
        aiString name;
        aiColor4D diffuse;
        // Assimp gives a material of this name to everything that has none.
        if ((material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS &&
             std::strcmp(name.C_Str(), AI_DEFAULT_MATERIAL_NAME) == 0) ||
            material.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) != aiReturn_SUCCESS)
            return how_.plain;
        return light_of(diffuse);
    }

    Colour light_of(const aiColor4D& c) const
    {
        const Encoding srgb;
        const auto light = [&](float v) {
            const double value = v >= 0 ? std::min(double(v), 1.0) : 0; // NaN: 0
            return float(linear_ ? value : decode(srgb, value));
        };
        return {light(c.r), light(c.g), light(c.b), 1};
    }

    /// Splits a polygon into triangles that share its first corner; its sides alone become edges.
    void take_face(const aiMesh& from, const aiFace& face, std::uint32_t first, Colour material)
    {
        const unsigned n = face.mNumIndices;
        const auto colour = [&](unsigned corner) {
            return colour_of(from, face.mIndices[corner]).value_or(material);
        };
        const auto vertex = [&](unsigned corner) {
            if (face.mIndices[corner] >= from.mNumVertices)
                throw std::runtime_error("a face names a vertex that is not there");
            return first + face.mIndices[corner];
        };
        for (unsigned k = 0; k < n; ++k)
            vertex(k); // checks the index before the colour is read
        const auto line = [&](unsigned a, unsigned b) {
            return MeshLine{{vertex(a), vertex(b)}, {colour(a), colour(b)}};
        };
        if (n == 1)
            mesh_.points.push_back({vertex(0), colour(0)});
        if (n == 2)
            mesh_.lines.push_back(line(0, 1));
        if (n < 3)
            return;
        Colour sum{0, 0, 0, 1};
        for (unsigned k = 0; k < n; ++k) {
            const Colour c = colour(k);
            sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b, 1};
            const unsigned next = (k + 1) % n;
            mesh_.face_edges.push_back(vertex(k) < vertex(next) ? line(k, next) : line(next, k));
        }
        const float part = 1 / float(n);
        for (unsigned k = 2; k < n; ++k)
            mesh_.triangles.push_back({{vertex(0), vertex(k - 1), vertex(k)},
                                       {part * sum.r, part * sum.g, part * sum.b, 1}});
    }

    const aiScene& scene_;
    MeshReading how_;
    bool linear_; ///< colours are linear light
    Mesh mesh_;
};

Mesh imported(const std::string& path, const MeshReading& how)
{
    Assimp::Importer importer;
    // Corners at one place and of one colour become one vertex, whatever else differs.
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                    aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS |
                                    aiComponent_ANIMATIONS | aiComponent_TEXTURES |
                                    aiComponent_LIGHTS | aiComponent_CAMERAS);
    const aiScene* scene = importer.ReadFile(path, aiProcess_RemoveComponent |
                                                       aiProcess_JoinIdenticalVertices);
    if (!scene || !scene->mRootNode) {
        const std::string reason = importer.GetErrorString();
        throw std::runtime_error(reason == "std::bad_alloc" ? "it takes more than 4 GB of memory"
                                                            : reason);
    }
    const std::string kind = extension_of(path);
    return SceneTaker(*scene, how, kind == "gltf" || kind == "glb").take();
}

void write_all(int file, const void* bytes, std::size_t count)
{
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t done = write(file, at, count);
        if (done <= 0)
            _exit(1);
        at += done;
        count -= std::size_t(done);
    }
}

template <class Thing> void write_all(int file, const std::vector<Thing>& things)
{
    const std::uint64_t count = things.size();
    write_all(file, &count, sizeof count);
    write_all(file, things.data(), count * sizeof(Thing));
}

/// The child's work: sends a 0 and the mesh, or a 1 and the error.
[[noreturn]] void import_into(int file, const std::string& path, const MeshReading& how)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        std::signal(number, SIG_DFL);
#ifndef __SANITIZE_ADDRESS__ // AddressSanitizer reserves terabytes of addresses
    const rlimit memory{most_memory, most_memory};
    setrlimit(RLIMIT_AS, &memory);
#endif
    const rlimit seconds{most_seconds, most_seconds}, no_core{0, 0};
    setrlimit(RLIMIT_CPU, &seconds);
    setrlimit(RLIMIT_CORE, &no_core);
    try {
        const Mesh mesh = imported(path, how);
        write_all(file, "\0", 1);
        write_all(file, mesh.vertices);
        write_all(file, mesh.points);
        write_all(file, mesh.lines);
        write_all(file, mesh.face_edges);
        write_all(file, mesh.triangles);
    } catch (const std::exception& error) {
        const std::string reason = reason_of(error);
        write_all(file, "\1", 1);
        write_all(file, reason.data(), reason.size());
    }
    _exit(0);
}

std::string read_all(int file)
{
    std::string bytes;
    char part[1 << 16];
    for (ssize_t count; (count = read(file, part, sizeof part)) > 0;)
        bytes.append(part, std::size_t(count));
    return bytes;
}

/// Reads what write_all has written; take() returns false if the data end too early.
class Received {
public:
    explicit Received(const std::string& bytes) : bytes_(bytes) {}
    template <class Thing> bool take(std::vector<Thing>& things)
    {
        std::uint64_t count = 0;
        if (bytes_.size() - at_ < sizeof count)
            return false;
        std::memcpy(&count, &bytes_[at_], sizeof count);
        at_ += sizeof count;
        if (count > (bytes_.size() - at_) / sizeof(Thing))
            return false;
        things.resize(count);
        std::memcpy(static_cast<void*>(things.data()), bytes_.data() + at_, count * sizeof(Thing));
        at_ += count * sizeof(Thing);
        return true;
    }

private:
    const std::string& bytes_;
    std::size_t at_ = 1;
};

} // namespace

Mesh read_by_assimp(const std::string& path, const MeshReading& how)
{
    if (access(path.c_str(), R_OK) != 0)
        throw InputError(path + ": " + std::strerror(errno));
    if (is_special(path)) // it may never end
        throw InputError(path + ": is not a regular file");
    int ends[2];
    if (pipe(ends) != 0)
        throw InputError(path + ": no pipe can be made: " + std::strerror(errno));
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        import_into(ends[1], path, how);
    }
    close(ends[1]);
    const std::string bytes = child > 0 ? read_all(ends[0]) : "";
    close(ends[0]);
    int status = 0;
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (child < 0)
        throw InputError(path + ": no process can be made to read it");
    if (bytes.size() > 1 && bytes[0] == 1)
        throw InputError(path + ": Assimp cannot read it: " + excerpt(bytes.substr(1), 200));
    Mesh mesh;
    Received received(bytes);
    const bool whole = !bytes.empty() && received.take(mesh.vertices) &&
                       received.take(mesh.points) && received.take(mesh.lines) &&
                       received.take(mesh.face_edges) && received.take(mesh.triangles);
    if (!whole)
        throw InputError(path + ": Assimp " +
                         (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU
                              ? "took more than 120 seconds for it"
                              : "crashed on it") +
                         "; the program that made it may write an .obj instead");
    mesh.is_cloud = mesh.lines.empty() && mesh.triangles.empty();
    return mesh;
}

} // namespace integral
