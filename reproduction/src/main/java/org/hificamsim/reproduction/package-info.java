/** The reproduction of the thesis's table, figures and statements, and of CamSim's studies. */
package org.hificamsim.reproduction;
