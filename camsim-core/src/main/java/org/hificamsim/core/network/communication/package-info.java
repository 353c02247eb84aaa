/** Communication policies: which cameras hear of a target for sale. */
package org.hificamsim.core.network.communication;
