/** Plans as files: tables, pages, pictures; and the check that they say what is true. */
package org.hificamsim.placement.output;
