package badlog.page.view

import badlog.analysis.Span

/** One of the places on the x axis at which [finding] was found. */
internal class FindingPlace(val finding: Finding, val span: Span)
