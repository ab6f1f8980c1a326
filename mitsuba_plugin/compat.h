/* What differs between the versions of Mitsuba that the plugin can be built for. */

#pragma once

#include <vector>

#include <drjit-core/jit.h>
#include <mitsuba/core/object.h>
#include <mitsuba/mitsuba.h>

NAMESPACE_BEGIN(mitsuba)

/// Memory that the processor can read, as the target of `drjit::migrate`.
#if MI_VERSION_MAJOR == 3 && MI_VERSION_MINOR < 9
inline constexpr AllocType HostMemory = AllocType::Host;
#else
inline constexpr JitBackend HostMemory = JitBackend::None;
#endif

/// Finds the shapes that are children of a scene's shapes: those in groups, which instances repeat. (Scenes
/// and groups list them only since 3.9.)
class GroupedShapes final : TraversalCallback {
public:
    static std::vector<Object *> in(Object *scene) {
        GroupedShapes visitor;
        scene->traverse(&visitor);
        return visitor.m_shapes;
    }

private:
    void put_value(std::string_view, void *, uint32_t, const std::type_info &) override {}
    void put_object(std::string_view, Object *object, uint32_t) override {
        if (!object || object->type() != ObjectType::Shape)
            return;
        if (m_in_shape) {
            m_shapes.push_back(object);
        } else {
            m_in_shape = true;
            object->traverse(this);
            m_in_shape = false;
        }
    }

    bool m_in_shape = false;
    std::vector<Object *> m_shapes;
};

NAMESPACE_END(mitsuba)
