/** A site as a covering problem: what is demanded, where cameras can be, and what they see. */
package org.hificamsim.placement.site;
