/** What each camera of the network sees, and how sure it is. */
package org.hificamsim.core.network.sight;
