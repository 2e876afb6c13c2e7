package badlog.page.app

import badlog.rules.LogFindings
import badlog.viewer.session.link.PageAddress

/**
 * The part of a log's page that stays when the log has grown.
 *
 * @property place the reader's position on the page; board and formulas are remembered separately.
 * @property found the findings to show until the rules have run again; null if they have not run.
 * @property ranAt the time at which the last run of the rules ended, on the browser's clock, in ms.
 */
internal class PageSnapshot(val place: PageAddress, val found: LogFindings?, val ranAt: Double)
