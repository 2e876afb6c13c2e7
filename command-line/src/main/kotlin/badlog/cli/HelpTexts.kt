package badlog.cli

import badlog.cli.text.wrapped

/** What every help text ends with. */
internal const val EXIT_CODES: String =
    "Exit code: 0 all is whole, 3 something was salvaged or left out, 1 nothing could be done, 2 wrong usage."

/** [text] in lines that fit a terminal, with room for the margin that help texts have. */
internal fun paragraph(text: String): String = wrapped("", text, width = HELP_WIDTH)

private const val HELP_WIDTH = 76
