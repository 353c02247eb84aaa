/** The thesis's Table 8.1, figures and statements, computed again and judged. */
package org.hificamsim.reproduction;
