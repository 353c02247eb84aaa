/** The thesis's table, figures and statements, computed again and judged; CamSim's studies, too. */
package org.hificamsim.reproduction;
