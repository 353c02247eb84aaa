/** Choosing among candidates that each see some samples: instances, search, bounds. */
package org.hificamsim.placement.cover;
