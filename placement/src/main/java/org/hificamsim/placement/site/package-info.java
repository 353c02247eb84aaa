/** A site as a covering problem: what is demanded, where cameras can be, what they see. */
package org.hificamsim.placement.site;
