/**
 * The thesis's Table 8.1, figures and statements, computed again and judged; what papers say of
 * CamSim.
 */
package org.hificamsim.reproduction;
