/** The channel between cameras: which messages are lost, late or dropped, and how long they are. */
@StableApi(since = "0.2")
package org.hificamsim.core.channel;

import org.hificamsim.core.StableApi;
