/** The vision graph: which camera remembers handing targets to which. */
package org.hificamsim.core.network.graph;
