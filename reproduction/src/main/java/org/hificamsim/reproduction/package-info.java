/** The thesis's Table 8.1, figures and statements, computed anew and judged. */
package org.hificamsim.reproduction;
