/** What each open parameter does to the conclusion of chapter 8. */
package org.hificamsim.reproduction.sensitivity;
