package badlog.core.conformance

import badlog.core.recording.ProblemKind.BLANK_LINE
import badlog.core.recording.ProblemKind.CARRIAGE_RETURNS
import badlog.core.recording.ProblemKind.EMPTY_CELLS
import badlog.core.recording.ProblemKind.HEADER_UNREADABLE
import badlog.core.recording.ProblemKind.LAST_CELL_CUT
import badlog.core.recording.ProblemKind.LINES_JOINED
import badlog.core.recording.ProblemKind.NO_ROWS
import badlog.core.recording.ProblemKind.QUOTES_REPAIRED
import badlog.core.recording.ProblemKind.ROW_CUT
import badlog.core.recording.ProblemKind.ROW_LONG
import badlog.core.recording.ProblemKind.ROW_SHORT
import badlog.core.recording.ProblemKind.TEXT_IN_NUMBERS

/** Files that end in the middle of something, rows with too few or too many cells, and other line ends. */
internal val CUT_CASES = listOf(
    case(
        "cut-row",
        "The last row lacks cells and its newline: dropped, whatever its cells hold.",
        DRIVE + "1,auto,12\n2,teleo",
        bag(time(1), mode("auto"), volts(12), problems = listOf(ROW_CUT at 4)),
    ),
    case(
        "cut-last-cell",
        "The last row has its cells but no newline: 11.5 may have become 1, so the cell is a gap and the row is kept.",
        DRIVE + "1,auto,12\n2,teleop,1",
        bag(
            time(1, 2),
            mode("auto", "teleop"),
            volts(12, null),
            problems = listOf(LAST_CELL_CUT at 4 of "Volts", EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "cut-before-last-cell",
        "Cut right behind the last comma: the last cell is as cut as if it had begun.",
        DRIVE + "1,auto,12\n2,teleop,",
        bag(
            time(1, 2),
            mode("auto", "teleop"),
            volts(12, null),
            problems = listOf(LAST_CELL_CUT at 4 of "Volts", EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "cut-first-row",
        "The only row is cut: there is none.",
        DRIVE + "1,au",
        bag(time(), mode(), volts(), problems = listOf(ROW_CUT at 3, NO_ROWS.anywhere)),
    ),
    case(
        "cut-one-column",
        "With one topic a cut row has all its cells; its only one is a gap.",
        """{"topics":[{"name":"A","unit":"V","attrs":[]}],"values":[]}""" + "\nA\n12\n1",
        bag(
            topic("A", "V", cells = cells(12, null)),
            problems = listOf(LAST_CELL_CUT at 4 of "A", EMPTY_CELLS of "A"),
        ),
    ),
    case(
        "cut-row-csv",
        "In a plain CSV file too a last row without all its cells and without a newline is cut.",
        DRIVE_TITLES + "1,auto,12\n2,teleo",
        csv(
            topic("Time", cells = cells(1)),
            mode("auto"),
            topic("Volts", cells = cells(12)),
            problems = listOf(ROW_CUT at 3),
        ),
    ),
    case(
        "cut-after-line-1-cut",
        "A bag whose line 1 is lost is still a bag: a last row without newline has a cut last cell.",
        DRIVE_JSON.take(30) + "\n" + DRIVE_TITLES + "1,auto,12\n2,auto,1",
        bag(
            topic("Time", cells = cells(1, 2)),
            mode("auto", "auto"),
            topic("Volts", cells = cells(12, null)),
            problems = listOf(
                HEADER_UNREADABLE at 1,
                LAST_CELL_CUT at 4 of "Volts",
                EMPTY_CELLS of "Volts",
            ),
        ),
    ),
    case(
        "cut-in-quotes",
        "Cut inside quotes: the row is dropped.",
        DRIVE + "1,auto,12\n2,\"teleop, le",
        bag(time(1), mode("auto"), volts(12), problems = listOf(ROW_CUT at 4)),
    ),
    case(
        "cut-in-quoted-lines",
        "Cut inside a quoted text of several lines: all of them are one row, which is dropped.",
        DRIVE + "1,auto,12\n2,\"teleop\nleft, fast\nand",
        bag(time(1), mode("auto"), volts(12), problems = listOf(ROW_CUT at 4)),
    ),
    case(
        "cut-in-last-quoted-cell",
        "An open quote in the last cell: the row would have its cells, but is cut.",
        """{"topics":[{"name":"Time","unit":"s","attrs":[]},{"name":"Mode","unit":"ul","attrs":[]}],"values":[]}""" +
            "\nTime,Mode\n1,auto\n2,\"tele",
        bag(time(1), mode("auto"), problems = listOf(ROW_CUT at 4)),
    ),
    case(
        "cut-quotes-in-one-column",
        "With one topic every line is a row: a quote that nothing closes swallows none of them.",
        """{"topics":[{"name":"A","unit":"V","attrs":[]}],"values":[]}""" + "\nA\n1\n\"2\n3\n4\n",
        bag(
            topic("A", "V", cells = cells(1, "\"2", 3, 4)),
            problems = listOf(QUOTES_REPAIRED at 4, TEXT_IN_NUMBERS at 4 of "A"),
        ),
    ),
    case(
        "cut-unescaped-quotes",
        "A last row whose quotes were not escaped but are all closed is not a cut row.",
        DRIVE + "1,auto,12\n2,\"say \"hi\"\",11\n",
        bag(time(1, 2), mode("auto", "say \"hi\""), volts(12, 11), problems = listOf(QUOTES_REPAIRED at 4)),
    ),
    case(
        "cut-torn-text",
        "A torn text in the last row, which lacks its newline: the pieces are joined, and only the last cell is a gap.",
        DRIVE + "1,auto,12\n2,tele\nop,1",
        bag(
            time(1, 2),
            mode("auto", "tele\nop"),
            volts(12, null),
            problems = listOf(LINES_JOINED at 4, LAST_CELL_CUT at 4 of "Volts", EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "torn-text-at-the-end-of-csv",
        "A torn text in the last row of a plain CSV file, which needs no newline.",
        DRIVE_TITLES + "1,auto,12\n2,tele\nop,11",
        csv(
            topic("Time", cells = cells(1, 2)),
            mode("auto", "tele\nop"),
            topic("Volts", cells = cells(12, 11)),
            problems = listOf(LINES_JOINED at 3),
        ),
    ),
    case(
        "short-rows",
        "A short row with its newline is kept, also as the last one; what it lacks are gaps, no cell moves.",
        DRIVE + "1,auto,12\n2\n3,teleop,10\n4,teleop\n",
        bag(
            time(1, 2, 3, 4),
            mode("auto", null, "teleop", "teleop"),
            volts(12, null, 10, null),
            problems = listOf(ROW_SHORT at 4, ROW_SHORT at 6, EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "long-rows",
        "A long row is kept without the cells that belong to no topic.",
        DRIVE + "1,auto,12,99\n2,teleop,11\n3,teleop,10,,x\n",
        bag(
            time(1, 2, 3),
            mode("auto", "teleop", "teleop"),
            volts(12, 11, 10),
            problems = listOf(ROW_LONG at 3, ROW_LONG at 5),
        ),
    ),
    case(
        "crlf",
        "Windows line ends, reported once; they are not part of the last cell.",
        DRIVE.replace("\n", "\r\n") + "1,auto,12\r\n2,teleop,off\r\n3,teleop,10\r\n\r\n4,\"a\r\nb\",9\r\n",
        bag(
            time(1, 2, 3, 4),
            mode("auto", "teleop", "teleop", "a\r\nb"),
            volts(12, "off", 10, 9),
            problems = listOf(
                BLANK_LINE at 6,
                TEXT_IN_NUMBERS at 4 of "Volts",
                CARRIAGE_RETURNS.anywhere,
            ),
        ),
    ),
    case(
        "cr",
        "A bare CR ends a line as well.",
        (DRIVE + "1,auto,12\n2,\"tele,op\",11\n").replace("\n", "\r"),
        bag(
            time(1, 2),
            mode("auto", "tele,op"),
            volts(12, 11),
            problems = listOf(CARRIAGE_RETURNS.anywhere),
        ),
    ),
    case(
        "crlf-cut-in-half",
        "A last row that ends in the CR of a CRLF is whole.",
        DRIVE + "1,auto,12\n2,teleop,11\r",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(CARRIAGE_RETURNS.anywhere)),
    ),
    case(
        "short-rows-of-numbers",
        "Two short rows that would make one are not joined: no newline stands inside a number.",
        "A,B,C\n1,2\n3,4\n5,6,7\n",
        csv(
            topic("A", cells = cells(1, 3, 5)),
            topic("B", cells = cells(2, 4, 6)),
            topic("C", cells = cells(null, null, 7)),
            problems = listOf(ROW_SHORT at 2, ROW_SHORT at 3),
        ),
    ),
)
