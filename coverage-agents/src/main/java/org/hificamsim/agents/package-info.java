/** The zoom policies, registered by name. */
@StableApi(since = "0.1")
package org.hificamsim.agents;

import org.hificamsim.core.StableApi;
