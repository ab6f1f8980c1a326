/* Records the library's kernels into Dr.Jit, for the variants that compile what they run.

   The library asks for one operation after the other; here each becomes a Dr.Jit variable. The kernel is then
   a part of the program that the renderer itself records: it is compiled with it, and nothing is called back
   while rendering. What is recorded is detached: gradients do not flow through the choice of samples. */

#pragma once

#include <exception>

#include <drjit/autodiff.h>
#include <mitsuba/core/logger.h>
#include <mitsuba/core/vector.h>

#include <spherecap.h>

NAMESPACE_BEGIN(mitsuba)

template <typename Float>
class Recorder {
public:
    using Mask = dr::mask_t<Float>;
    using Vector3f = Vector<Float, 3>;
    static constexpr JitBackend Backend = dr::backend_v<Float>;

    /// A constant input.
    static spherecap_term_t term(float constant) { return {0, constant}; }

    /// A variable, which must outlive the recording.
    static spherecap_term_t term(const Float &value) { return {value.index(), 0.f}; }

    /// Three of them, in an array of the library's.
    template <typename Vector>
    static void terms(const Vector &value, spherecap_term_t (&out)[3]) {
        for (size_t i = 0; i < 3; ++i)
            out[i] = term(value[i]);
    }

    /// Calls a `spherecap_record_...` function.
    template <typename Result, typename Input>
    Result record(uint32_t (*function)(const spherecap_recorder_t *, const spherecap_recorded_cap_t *,
                                       const spherecap_term_t *, Result *),
                  const spherecap_recorded_cap_t &cap, const Input &input) {
        const spherecap_recorder_t recorder{this, literal, op, release};
        Result result;
        const uint32_t status = function(&recorder, &cap, input, &result);
        if (m_error)
            std::rethrow_exception(m_error);
        if (status != SPHERECAP_STATUS_OK)
            Throw("The spherecap kernel could not be recorded: %s.", spherecap_status_message(status));
        return result;
    }

    /// Takes over nodes of a result.
    static Float number(uint64_t node) { return Float::steal(node); }
    static Mask mask(uint64_t node) { return Mask::steal(node); }
    static Vector3f vector(const uint64_t (&nodes)[3]) {
        return {number(nodes[0]), number(nodes[1]), number(nodes[2])};
    }

private:
    // Exceptions must not pass through the library: they wait until it has returned.
    template <typename Body>
    static uint64_t guarded(void *user, const Body &body) noexcept {
        try {
            return body();
        } catch (...) {
            static_cast<Recorder *>(user)->m_error = std::current_exception();
            return 0;
        }
    }

    static uint64_t literal(void *user, float value) noexcept {
        return guarded(user, [&] { return jit_var_f32(Backend, value); });
    }

    static void release(void *, uint64_t node) noexcept { jit_var_dec_ref(uint32_t(node)); }

    static uint64_t op(void *user, spherecap_op_t op, const uint64_t *operands) noexcept {
        return guarded(user, [&]() -> uint32_t {
            const auto a = [&] { return uint32_t(operands[0]); };
            const auto b = [&] { return uint32_t(operands[1]); };
            const auto c = [&] { return uint32_t(operands[2]); };
            switch (op) {
            case SPHERECAP_OP_ADD:
                return jit_var_add(a(), b());
            case SPHERECAP_OP_SUB:
                return jit_var_sub(a(), b());
            case SPHERECAP_OP_MUL:
                return jit_var_mul(a(), b());
            case SPHERECAP_OP_DIV:
                return jit_var_div(a(), b());
            case SPHERECAP_OP_FMA:
                return jit_var_fma(a(), b(), c());
            case SPHERECAP_OP_NEG:
                return jit_var_neg(a());
            case SPHERECAP_OP_ABS:
                return jit_var_abs(a());
            case SPHERECAP_OP_SQRT:
                return jit_var_sqrt(a());
            case SPHERECAP_OP_LT:
                return jit_var_lt(a(), b());
            case SPHERECAP_OP_LE:
                return jit_var_le(a(), b());
            case SPHERECAP_OP_AND:
                return jit_var_and(a(), b());
            case SPHERECAP_OP_OR:
                return jit_var_or(a(), b());
            case SPHERECAP_OP_NOT:
                return jit_var_not(a());
            case SPHERECAP_OP_SELECT:
                return jit_var_select(a(), b(), c());
            case SPHERECAP_OP_POWER_OF_TWO:
                return power_of_two(a());
            case SPHERECAP_OP_BITS:
                return cast(cast(a(), VarType::Int32, true), VarType::Float32, false, true);
            case SPHERECAP_OP_FLOAT_OF_BITS:
                return cast(cast(a(), VarType::Int32, false), VarType::Float32, true, true);
            }
            return 0;
        });
    }

    static uint32_t power_of_two(uint32_t node) {
        const uint32_t bits = cast(node, VarType::UInt32, true);
        const uint32_t exponent = jit_var_u32(Backend, 0x7f800000);
        const uint32_t power = jit_var_and(bits, exponent);
        jit_var_dec_ref(exponent);
        jit_var_dec_ref(bits);
        return cast(power, VarType::Float32, true, true);
    }

    static uint32_t cast(uint32_t node, VarType type, bool reinterpret, bool consume = false) {
        const uint32_t result = jit_var_cast(node, type, reinterpret);
        if (consume)
            jit_var_dec_ref(node);
        return result;
    }

    std::exception_ptr m_error;
};

NAMESPACE_END(mitsuba)
