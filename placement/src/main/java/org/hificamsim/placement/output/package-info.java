/** Plans as files: tables, pages and pictures; and the check that what they say is true. */
package org.hificamsim.placement.output;
