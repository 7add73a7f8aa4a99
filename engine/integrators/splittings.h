// Coefficients of the splittings.  Where a source prints fifteen digits, more were won by carrying them,
// along the shortest way, onto the order conditions (largest residual < 1e-44): no coefficient moved by more
// than 4e-15.  Names: a is a drift's, b a kick's.
#pragma once

#include "engine/integrators/coefficient.h"

namespace cylon::engine {

/// The palindrome of which `half` is the first half with its middle.
template <std::size_t N>
constexpr std::array<Coefficient, 2 * N - 1> palindrome(const std::array<long double, N>& half) {
  std::array<Coefficient, 2 * N - 1> whole{};
  for (std::size_t i = 0; i < N; ++i) whole[i] = whole[2 * N - 2 - i] = static_cast<Coefficient>(half[i]);
  return whole;
}

/// Velocity Verlet steps over the weights, one after another, with the kicks that meet made one:
///   w1/2, w1, (w1 + w2)/2, w2, ..., wn/2
template <std::size_t N>
constexpr std::array<Coefficient, 2 * N + 1> fused(const std::array<Coefficient, N>& weights) {
  std::array<Coefficient, 2 * N + 1> parts{};
  for (std::size_t i = 0; i < N; ++i) {
    parts[2 * i] += weights[i] / 2;
    parts[2 * i + 1] = weights[i];
    parts[2 * i + 2] += weights[i] / 2;
  }
  return parts;
}

inline constexpr std::array<Coefficient, 1> whole_step = {1};
inline constexpr std::array<Coefficient, 2> euler_parts = {1, 1};
inline constexpr auto verlet_parts = palindrome<2>({0.5L, 1});

// H. Yoshida, Phys. Lett. A 150 (1990) 262: order 4, weight 1/(2 - 2^(1/3)), eq. 2.11; order 6, solution A of
// table 1.
inline constexpr auto yoshida4_weights =
    palindrome<2>({1.35120719195965763404769L, -1.70241438391931526809538L});
inline constexpr auto yoshida6_weights = palindrome<4>({0.784513610477557263819498L,  //
                                                        0.235573213359358133684793L,  //
                                                        -1.17767998417887100694642L,  //
                                                        1.31518632068391121888425L});
inline constexpr auto yoshida4_parts = fused(yoshida4_weights);
inline constexpr auto yoshida6_parts = fused(yoshida6_weights);

// S. Blanes, P. C. Moan, Practical symplectic partitioned Runge-Kutta and Runge-Kutta-Nystrom methods,
// J. Comput. Appl. Math. 142 (2002) 313.
// Table 2, S6 of order 4 and S10 of order 6: a1 b1 a2 b2 ...
inline constexpr auto bm4_parts = palindrome<7>({0.0792036964311956694336635L,   //
                                                 0.209515106613362021274073L,    //
                                                 0.353172906049773988481061L,    //
                                                 -0.143851773179818008275115L,   //
                                                 -0.0420650803577195353681103L,  //
                                                 0.434336666566455987001042L,    //
                                                 0.219376955753499754906771L});
inline constexpr auto bm6_parts = palindrome<11>({0.0502627644003926860212217L,   //
                                                  0.148816447901043231920901L,    //
                                                  0.413514300428343815063064L,    //
                                                  -0.132385865767783647448845L,   //
                                                  0.0450798897943980629688971L,   //
                                                  0.0673076046921844581502579L,   //
                                                  -0.188054853819568914799128L,   //
                                                  0.432666402578173597527668L,    //
                                                  0.541960678450780134831415L,    //
                                                  -0.0164045894036176401499814L,  //
                                                  -0.725525558508691568170937L});
// Table 3, SRKN 6b of order 4: b1 a1 b2 a2 ...; SRKN 14a of order 6: a1 b1 a2 b2 ...  Valid because T is
// quadratic in the momenta: [V, [V, [V, T]]] = 0.
inline constexpr auto rkn4_parts = palindrome<7>({0.0829844064174050188383475L,   //
                                                  0.245298957184271162603932L,    //
                                                  0.396309801498368077094912L,    //
                                                  0.604872665711079974960893L,    //
                                                  -0.0390563049223484351708653L,  //
                                                  -0.350171622895351137564825L,   //
                                                  0.119524194013150678475213L});
inline constexpr auto rkn6_parts = palindrome<15>({0.0378593198406109414470212L,    //
                                                   0.0917191526244620179811832L,    //
                                                   0.102635633102436552847082L,     //
                                                   0.183983170005004898491477L,     //
                                                   -0.025867888266558333163947L,    //
                                                   -0.056534365832889104395277L,    //
                                                   0.314241403071446434147143L,     //
                                                   0.00491468877471188564020562L,   //
                                                   -0.130144459517415113849615L,    //
                                                   0.143761127168361682387375L,     //
                                                   0.10641770036954136802228L,      //
                                                   0.328567693746804140200481L,     //
                                                   -0.00879424312851020439406943L,  //
                                                   -0.196411466486455520305444L,    //
                                                   0.207305069056896709888211L});

}  // namespace cylon::engine
