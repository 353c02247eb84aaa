/** Choosing among candidates that each cover some points: instances, search, and bounds. */
package org.hificamsim.placement.cover;
