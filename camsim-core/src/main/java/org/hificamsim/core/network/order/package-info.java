/** Iteration orders of CamSim that results depend on, without its maps. */
package org.hificamsim.core.network.order;
