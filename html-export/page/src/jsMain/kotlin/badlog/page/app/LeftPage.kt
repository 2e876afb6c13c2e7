package badlog.page.app

import badlog.rules.LogFindings
import badlog.viewer.session.link.PageAddress

/**
 * What stays of the page of a log when the log has grown.
 *
 * @property place where the reader is; board and formulas are remembered anyway.
 * @property found what the rules found, until they have run again; null if they have not run.
 * @property ranAt when they had run, on the browser's clock, in ms.
 */
internal class LeftPage(val place: PageAddress, val found: LogFindings?, val ranAt: Double)
