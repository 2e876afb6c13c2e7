package badlog.viewer.input

/** The syntax of a search, for the help of page and window. */
val SEARCH_HELP: List<HelpLine> = listOf(
    HelpLine("Search", "left speed", "Both words, in any order; also stalled for stalls, browned out for brownout."),
    HelpLine("Search", "\"left speed\"", "These words together."),
    HelpLine("Search", "left | right", "One or the other."),
    HelpLine("Search", "-right", "Not this word."),
    HelpLine("Search", "is:state", "States; also is:number, is:event, is:constant, is:empty."),
    HelpLine("Search", "has:finding", "Topics that a finding is about."),
)
