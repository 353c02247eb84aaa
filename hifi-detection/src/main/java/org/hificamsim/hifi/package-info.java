/** High-fidelity target detection: confidence as {@code g(f(q, d, z))} (thesis 3.4). */
package org.hificamsim.hifi;
