/**
 * Sites: candidates that each cover some points, of which a plan chooses those that cover most or
 * cost least. Begin with {@link org.hificamsim.solver.cover.CoverSearch}.
 */
package org.hificamsim.solver.cover;
