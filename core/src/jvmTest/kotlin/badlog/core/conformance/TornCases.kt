package badlog.core.conformance

import badlog.core.recording.ProblemKind.BLANK_LINE
import badlog.core.recording.ProblemKind.EMPTY_CELLS
import badlog.core.recording.ProblemKind.LINES_JOINED
import badlog.core.recording.ProblemKind.QUOTES_REPAIRED
import badlog.core.recording.ProblemKind.ROW_SHORT
import badlog.core.recording.ProblemKind.TEXT_IN_NUMBERS
import badlog.core.recording.TopicKind.STATE

/** Texts with raw newlines and with quotes that were not escaped, as the original writes them. */
internal val TORN_CASES = listOf(
    case(
        "torn-text",
        "A raw newline inside a text has torn its row in two; together the pieces have the right number of cells.",
        DRIVE + "1,auto\nleft,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto\nleft", "teleop"), volts(12, 11), problems = listOf(LINES_JOINED at 3)),
    ),
    case(
        "torn-text-in-three",
        "Two newlines in one text.",
        DRIVE + "1,auto,12\n2,a\nb\nc,11\n3,teleop,10\n",
        bag(time(1, 2, 3), mode("auto", "a\nb\nc", "teleop"), volts(12, 11, 10), problems = listOf(LINES_JOINED at 4)),
    ),
    case(
        "torn-text-with-a-blank-line",
        "A blank line inside a torn text is part of it.",
        DRIVE + "1,auto\n\nleft,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto\n\nleft", "teleop"), volts(12, 11), problems = listOf(LINES_JOINED at 3)),
    ),
    case(
        "torn-text-of-a-number-and-words",
        "One piece of the text may look like a number.",
        DRIVE + "1,12\nvolts low,12\n2,teleop,11\n",
        bag(time(1, 2), mode("12\nvolts low", "teleop"), volts(12, 11), problems = listOf(LINES_JOINED at 3)),
    ),
    case(
        "short-row-before-a-whole-one",
        "The row below is complete by itself, so it is never taken for the rest of a short one.",
        DRIVE + "1,au\n2,teleop,11\n3,teleop,10\n",
        bag(
            time(1, 2, 3),
            mode("au", "teleop", "teleop"),
            volts(null, 11, 10),
            problems = listOf(ROW_SHORT at 3, EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "short-row-blank-line-torn-row",
        "A short row of a number and a torn row below a blank line: a number is not a piece of a text.",
        "A,B,C\n1\n\n4,te\nst,9\n5,on,8\n",
        csv(
            topic("A", cells = cells(1, 4, 5)),
            topic("B", kind = STATE, cells = cells(null, "te\nst", "on")),
            topic("C", cells = cells(null, 9, 8)),
            problems = listOf(
                ROW_SHORT at 2,
                BLANK_LINE at 3,
                LINES_JOINED at 4,
                EMPTY_CELLS of "C",
            ),
        ),
    ),
    case(
        "unescaped-quotes",
        "Quotes in the middle of an unquoted cell are characters.",
        DRIVE + "1,say \"hi\",12\n2,5\" wheel,11\n",
        bag(
            time(1, 2),
            mode("say \"hi\"", "5\" wheel"),
            volts(12, 11),
            problems = listOf(QUOTES_REPAIRED at 3, QUOTES_REPAIRED at 4),
        ),
    ),
    case(
        "unescaped-quotes-in-quotes",
        "A quoted cell ends at a quote before a comma or the line's end; quotes before that are characters.",
        DRIVE + "1,\"he said \"hi\"\",12\n2,\"a \"b\" c\",11\n3,teleop,10\n",
        bag(
            time(1, 2, 3),
            mode("he said \"hi\"", "a \"b\" c", "teleop"),
            volts(12, 11, 10),
            problems = listOf(QUOTES_REPAIRED at 3, QUOTES_REPAIRED at 4),
        ),
    ),
    case(
        "unescaped-quote-before-a-comma",
        "A quote and a comma inside a text look like its end; the number of cells shows that they are not.",
        DRIVE + "1,\"he said \"a\", ok\",12\n2,teleop,11\n",
        bag(time(1, 2), mode("he said \"a\", ok", "teleop"), volts(12, 11), problems = listOf(QUOTES_REPAIRED at 3)),
    ),
    case(
        "unescaped-quote-at-the-start",
        "A quote that nothing closes is a character: the row has its cells then, and the rows below are not touched.",
        DRIVE + "1,\"auto,12\n2,teleop,11\n3,teleop,10\n",
        bag(
            time(1, 2, 3),
            mode("\"auto", "teleop", "teleop"),
            volts(12, 11, 10),
            problems = listOf(QUOTES_REPAIRED at 3),
        ),
    ),
    case(
        "unescaped-quotes-around-a-row",
        "Two such quotes might hold the row between them as a quoted text, but a complete row is never swallowed.",
        DRIVE + "1,\"auto,12\n2,teleop,11\n3,off\",10\n",
        bag(
            time(1, 2, 3),
            mode("\"auto", "teleop", "off\""),
            volts(12, 11, 10),
            problems = listOf(QUOTES_REPAIRED at 3, QUOTES_REPAIRED at 5),
        ),
    ),
    case(
        "unescaped-quote-in-an-odd-row",
        "Nothing closes the quote, and the rows below look unlike its row; they are complete, so none is swallowed.",
        "Name,Volts\nA,1\n3,\"31\nB,2\nC,3\n",
        csv(
            topic("Name", kind = STATE, cells = cells("A", 3, "B", "C")),
            topic("Volts", cells = cells(1, "\"31", 2, 3)),
            problems = listOf(QUOTES_REPAIRED at 3, TEXT_IN_NUMBERS at 3 of "Volts"),
        ),
    ),
    case(
        "text-after-a-closing-quote",
        "A quote that closes and is followed by text did not quote the cell.",
        DRIVE + "1,\"auto\" left,12\n2,teleop,11\n",
        bag(time(1, 2), mode("\"auto\" left", "teleop"), volts(12, 11), problems = listOf(QUOTES_REPAIRED at 3)),
    ),
    case(
        "torn-last-text",
        "A raw newline inside the text of the last topic: a line of one text belongs to the row above it.",
        """{"topics":[{"name":"Time","unit":"s","attrs":[]},{"name":"Mode","unit":"ul","attrs":[]}],"values":[]}""" +
            "\nTime,Mode\n1,auto\n2,Error\n\tat turn(Drive:12)\n\tat run(Robot:80)\n3,auto\n",
        bag(
            time(1, 2, 3),
            mode("auto", "Error\n\tat turn(Drive:12)\n\tat run(Robot:80)", "auto"),
            problems = listOf(LINES_JOINED at 5, LINES_JOINED at 6),
        ),
    ),
)
