#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "geometry/accel.h"
#include "scene/read.h"

namespace vitrail {

void add_validate_command(CLI::App& app, int&) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("validate", "Check a lowered scene without rendering it");
  command->add_option("scene", *path, "lowered scene, JSON")->required();
  command->callback([path] {
    // Building the intersector asks what meshes enclose, the last place where input can be wrong.
    const Scene scene = read_scene(*path);
    const Intersector intersector(scene);
    std::printf("%s: %zu objects, %zu materials, %zu lights, %zu bands, %llu primitives\n", path->c_str(),
                scene.objects.size(), scene.materials.size(), scene.lights.size(), scene.bands.size(),
                static_cast<unsigned long long>(intersector.primitive_count()));
  });
}

}  // namespace vitrail
