/** Planning where to mount cameras on a site. */
package org.hificamsim.placement;
