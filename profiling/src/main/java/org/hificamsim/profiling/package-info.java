/** Fits detection models to photos, as chapters 3 to 6 do. */
package org.hificamsim.profiling;
