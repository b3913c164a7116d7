// The cohesion of Becker and Teschner (becker_2007.hpp) with less of it between close particles, so
// that they do not cluster (Huber et al. 2015, section 3.2.4 and figure 2).
//
// Huber et al. say that the force is cut at a certain distance, not at which, nor whether it ends
// there or grows no further. Here the kernel grows no further below one particle spacing s:
//     a_i = -phi / m_i sum_j m_j (x_i - x_j) W(max(|x_i - x_j|, s))
// s because particles closer than that are those that pressure has to part, and no jump because
// scenes start as lattices whose neighbors lie at exactly s: rounding would decide which of them
// pull. With no pull at all below s a drop of 1000 particles fell into pairs in one place, the
// opposite of what the cut is for. SPlisHSPlasH's form of the model of Becker and Teschner does the
// same.
#pragma once

#include "becker_2007.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class HuberTension : public SurfaceTensionModel<Real, Dimension> {
public:
    using SurfaceTensionModel<Real, Dimension>::SurfaceTensionModel;

    static TensionModelRow row() { return {"huber_2015", {}, nullptr, false, false}; }

    void add_accelerations(Fluid<Real, Dimension>& fluid) override {
        add_cohesion(this->options.coefficient, static_cast<Real>(this->rest_spacing), fluid);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
