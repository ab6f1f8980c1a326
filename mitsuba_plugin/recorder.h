/* Records the library's kernels into Dr.Jit, for the variants that compile what they run.

   The library asks for one operation after the other; here each becomes a Dr.Jit variable, and a side of a
   branch a symbolic conditional, which is skipped where no path that is traced together needs it. The kernel
   is then a part of the program that the renderer itself records: it is compiled with it, and nothing is
   called back while rendering. What is recorded is detached: gradients do not flow through the choice of
   samples. */

#pragma once

#include <algorithm>
#include <exception>
#include <vector>

#include <drjit/autodiff.h>
#include <mitsuba/core/logger.h>
#include <mitsuba/core/vector.h>

#include <spherecap_record.h>

NAMESPACE_BEGIN(mitsuba)

/// What the library calls. It knows variables by their indices alone, whatever the types of the variant.
class RecorderBase {
protected:
    explicit RecorderBase(JitBackend backend) : m_backend(backend) {}

    /// Calls a `spherecap_record_...` function with what it takes between the recorder and the result.
    template <typename Result, typename Function, typename... Inputs>
    Result record(Function function, const Inputs &...inputs) {
        // The library asks for nothing twice. With a hundred lights, looking for it was a quarter of the
        // time.
        const dr::scoped_set_flag unnumbered(JitFlag::ValueNumbering, false);
        const bool conditionals = jit_flag(JitFlag::SymbolicConditionals);
        const spherecap_recorder_t recorder{
            this, literal, op, release, conditionals ? begin_if : nullptr, conditionals ? end_if : nullptr};
        Result result;
        const uint32_t status = function(&recorder, inputs..., &result);
        while (!m_open.empty()) // after an error
            leave();
        if (m_error)
            std::rethrow_exception(m_error);
        if (status != SPHERECAP_STATUS_OK)
            Throw("The spherecap kernel could not be recorded: %s.", spherecap_status_message(status));
        return result;
    }

private:
    // Exceptions must not pass through the library: they wait until it has returned.
    template <typename Body>
    static uint64_t guarded(void *user, const Body &body) noexcept {
        RecorderBase &self = *static_cast<RecorderBase *>(user);
        try {
            return body(self);
        } catch (...) {
            self.m_error = std::current_exception();
            return 0;
        }
    }

    static uint64_t literal(void *user, float value) noexcept {
        return guarded(user, [&](RecorderBase &self) { return jit_var_f32(self.m_backend, value); });
    }

    static void release(void *, uint64_t node) noexcept { jit_var_dec_ref(uint32_t(node)); }

    /// Begins a symbolic conditional, as `drjit::if_stmt` does; its other side will give zeros.
    static uint64_t begin_if(void *user, uint64_t node) noexcept {
        return guarded(user, [&](RecorderBase &self) -> uint32_t {
            const uint32_t condition = uint32_t(node);
            if (jit_var_state(condition) == VarState::Literal)
                return 0;
            const JitBackend backend = self.m_backend;
            const Variable active(jit_var_mask_apply(condition, uint32_t(jit_var_size(condition)))),
                always(jit_var_bool(backend, true));
            // What the other side gives. It is made here because Dr.Jit may take it for the result.
            const uint32_t zero = jit_var_f32(backend, 0.f), never = jit_var_bool(backend, false);
            const bool is_symbolic = jit_flag(JitFlag::SymbolicScope);
            const uint32_t checkpoint = jit_record_begin(backend, nullptr);
            jit_new_scope(backend);
            const uint32_t conditional =
                jit_var_cond_start("spherecap branch", is_symbolic, active.index, never);
            // CUDA's threads branch one by one: those that get there are active.
            jit_var_mask_push(backend, backend == JitBackend::LLVM ? active.index : always.index);
            self.m_open.push_back({conditional, checkpoint, zero, never});
            return conditional;
        });
    }

    static uint32_t end_if(void *user, uint64_t, uint64_t *nodes, size_t count) noexcept {
        return guarded(user, [&](RecorderBase &self) -> uint32_t {
            const Open &open = self.m_open.back();
            std::vector<uint32_t> results(nodes, nodes + count);
            const Variable yes(jit_var_cond_append(open.conditional, results.data(), count));
            for (uint32_t &result : results)
                result = jit_var_type(result) == VarType::Bool ? open.never : open.zero;
            const Variable no(jit_var_cond_append(open.conditional, results.data(), count));
            jit_var_cond_end(open.conditional, results.data());
            std::copy(results.begin(), results.end(), nodes);
            self.leave();
            return 1;
        });
    }

    void leave() {
        const Open open = m_open.back();
        m_open.pop_back();
        jit_var_mask_pop(m_backend);
        jit_record_end(m_backend, open.checkpoint, false);
        for (uint32_t index : {open.conditional, open.zero, open.never})
            jit_var_dec_ref(index);
    }

    static uint64_t op(void *user, spherecap_op_t op, const uint64_t *operands,
                       uint32_t is_rounded) noexcept {
        return guarded(user, [&](RecorderBase &self) -> uint32_t {
            const auto a = [&] { return uint32_t(operands[0]); };
            const auto b = [&] { return uint32_t(operands[1]); };
            const auto c = [&] { return uint32_t(operands[2]); };
            switch (op) {
            case SPHERECAP_OP_ADD:
                return jit_var_add(a(), b());
            case SPHERECAP_OP_SUB:
                return jit_var_sub(a(), b());
            case SPHERECAP_OP_MUL:
                return is_rounded ? self.product(a(), b()) : jit_var_mul(a(), b());
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
                return power_of_two(self.m_backend, a());
            case SPHERECAP_OP_BITS:
                return cast(a(), VarType::Int32, true, VarType::Float32, false);
            case SPHERECAP_OP_FLOAT_OF_BITS:
                return cast(a(), VarType::Int32, false, VarType::Float32, true);
            }
            return 0;
        });
    }

    /// A product that is fused into no sum. LLVM fuses none. CUDA's assembler does, unless the product is a
    /// sum already: of itself and -0, which no product is changed by. Dr.Jit would make a product of that
    /// again, so it is given the next number, which CUDA's instructions take for -0.
    uint32_t product(uint32_t a, uint32_t b) const {
        const uint32_t product = jit_var_mul(a, b);
        if (m_backend != JitBackend::CUDA || jit_var_state(product) == VarState::Literal)
            return product;
        jit_var_dec_ref(product);
        const Variable nothing(jit_var_f32(m_backend, -0x1p-149f));
        return jit_var_fma(a, b, nothing.index);
    }

    static uint32_t power_of_two(JitBackend backend, uint32_t node) {
        const Variable bits(jit_var_cast(node, VarType::UInt32, true)),
            exponent(jit_var_u32(backend, 0x7f800000)), power(jit_var_and(bits.index, exponent.index));
        return jit_var_cast(power.index, VarType::Float32, true);
    }

    /// A cast to one type, and from there to another.
    static uint32_t cast(uint32_t node, VarType by, bool by_bits, VarType to, bool to_bits) {
        const Variable between(jit_var_cast(node, by, by_bits));
        return jit_var_cast(between.index, to, to_bits);
    }

    /// A variable that is released.
    struct Variable {
        explicit Variable(uint32_t index) : index(index) {}
        Variable(const Variable &) = delete;
        ~Variable() { jit_var_dec_ref(index); }
        const uint32_t index;
    };

    /// A conditional that has not ended.
    struct Open {
        uint32_t conditional, checkpoint, zero, never;
    };

    const JitBackend m_backend;
    std::vector<Open> m_open;
    std::exception_ptr m_error;
};

/// The same with the types of a variant.
template <typename Float>
class Recorder : RecorderBase {
public:
    using Mask = dr::mask_t<Float>;
    using Vector3f = Vector<Float, 3>;

    Recorder() : RecorderBase(dr::backend_v<Float>) {}

    using RecorderBase::record;

    /// A mask as wide as what it decides about: Dr.Jit's conditionals want it so.
    static Mask condition(const Mask &mask, size_t width) {
        return mask.size() == 1 && width > 1 ? Mask::steal(jit_var_resize(mask.index(), width)) : mask;
    }

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

    /// Takes over nodes of a result.
    static Float number(uint64_t node) { return Float::steal(node); }
    static Mask mask(uint64_t node) { return Mask::steal(node); }
    static Vector3f vector(const uint64_t (&nodes)[3]) {
        return {number(nodes[0]), number(nodes[1]), number(nodes[2])};
    }
};

NAMESPACE_END(mitsuba)
