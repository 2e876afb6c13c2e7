package badlog.core.conformance

import badlog.core.recording.ProblemKind.BLANK_LINE
import badlog.core.recording.ProblemKind.EMPTY_CELLS
import badlog.core.recording.ProblemKind.EMPTY_FILE
import badlog.core.recording.ProblemKind.HEADER_UNREADABLE
import badlog.core.recording.ProblemKind.LAST_CELL_CUT
import badlog.core.recording.ProblemKind.LINES_JOINED
import badlog.core.recording.ProblemKind.NO_ROWS
import badlog.core.recording.ProblemKind.NUL_HOLE
import badlog.core.recording.ProblemKind.ROW_CUT
import badlog.core.recording.ProblemKind.ROW_SHORT

/** Runs of NUL bytes, which file systems leave after a loss of power. A hole is on the line on which it begins. */
internal val HOLE_CASES = listOf(
    case(
        "nul-only",
        "Nothing but NULs is as good as nothing.",
        nuls(64),
        csv(problems = listOf(NUL_HOLE at 1, EMPTY_FILE.anywhere)),
    ),
    case(
        "nul-at-the-end",
        "The file was made longer and never filled: no row is lost for certain, but something is.",
        DRIVE + "1,auto,12\n2,teleop,11\n" + nuls(100),
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(NUL_HOLE at 5)),
    ),
    case(
        "nul-in-the-last-cell",
        "A row cut by a hole is like one cut by the end: with all its cells it is kept, but for the last one.",
        DRIVE + "1,auto,12\n2,teleop,1" + nuls(10),
        bag(
            time(1, 2),
            mode("auto", "teleop"),
            volts(12, null),
            problems = listOf(LAST_CELL_CUT at 4 of "Volts", NUL_HOLE at 4, EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "nul-in-the-last-row",
        "Without all its cells it is dropped.",
        DRIVE + "1,auto,12\n2,tel" + nuls(10),
        bag(time(1), mode("auto"), volts(12), problems = listOf(ROW_CUT at 4, NUL_HOLE at 4)),
    ),
    case(
        "nul-in-csv",
        "Before a hole a last cell may be cut in a plain CSV file too.",
        "Time,Volts\n1,12\n2,1" + nuls(10),
        csv(
            topic("Time", cells = cells(1, 2)),
            topic("Volts", cells = cells(12, null)),
            problems = listOf(LAST_CELL_CUT at 3 of "Volts", NUL_HOLE at 3, EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "nul-between-rows",
        "What follows a hole is kept when it is a row.",
        DRIVE + "1,auto,12\n" + nuls(1) + "3,teleop,10\n4,teleop,9\n",
        bag(time(1, 3, 4), mode("auto", "teleop", "teleop"), volts(12, 10, 9), problems = listOf(NUL_HOLE at 4)),
    ),
    case(
        "nul-inside-rows",
        "A hole from inside one row to inside another: both are cut, one at its end, one at its beginning.",
        DRIVE + "1,auto,12\n2,au" + nuls(4096) + "eop,10\n4,teleop,9\n",
        bag(
            time(1, 4),
            mode("auto", "teleop"),
            volts(12, 9),
            problems = listOf(ROW_CUT at 4, NUL_HOLE at 4, ROW_CUT at 4),
        ),
    ),
    case(
        "nul-before-a-newline",
        "A hole that ends right before a newline cuts no second row, nor is there a blank line.",
        DRIVE + "1,auto,12\n2,au" + nuls(8) + "\n4,teleop,9\n",
        bag(time(1, 4), mode("auto", "teleop"), volts(12, 9), problems = listOf(ROW_CUT at 4, NUL_HOLE at 4)),
    ),
    case(
        "nul-then-ordinary-damage",
        "Only the line on which a hole ends is doubtful; short, blank and torn lines below are as anywhere.",
        DRIVE + "1,auto,12\n" + nuls(8) + "\n2\n3,teleop,10\n\n4,te\nst,9\n5,teleop,8\n",
        bag(
            time(1, 2, 3, 4, 5),
            mode("auto", null, "teleop", "te\nst", "teleop"),
            volts(12, null, 10, 9, 8),
            problems = listOf(
                NUL_HOLE at 4,
                ROW_SHORT at 5,
                BLANK_LINE at 7,
                LINES_JOINED at 8,
                EMPTY_CELLS of "Volts",
            ),
        ),
    ),
    case(
        "nul-then-a-short-row-later",
        "A short row after a hole and a good row is a short row.",
        DRIVE + "1,auto,12\n" + nuls(8) + "2,teleop,11\n3\n4,teleop,9\n",
        bag(
            time(1, 2, 3, 4),
            mode("auto", "teleop", null, "teleop"),
            volts(12, 11, null, 9),
            problems = listOf(NUL_HOLE at 4, ROW_SHORT at 5, EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "nul-several",
        "Every hole is reported.",
        DRIVE + "1,auto,12\n" + nuls(3) + "2,teleop,11\n3,te" + nuls(4) + "\n4,teleop,9\n" + nuls(2),
        bag(
            time(1, 2, 4),
            mode("auto", "teleop", "teleop"),
            volts(12, 11, 9),
            problems = listOf(NUL_HOLE at 4, ROW_CUT at 5, NUL_HOLE at 5, NUL_HOLE at 7),
        ),
    ),
    case(
        "nul-at-the-start",
        "NULs before the JSON hide nothing of it.",
        nuls(16) + DRIVE + "1,auto,12\n",
        bag(time(1), mode("auto"), volts(12), problems = listOf(NUL_HOLE at 1)),
    ),
    case(
        "nul-in-line-1",
        "A hole in the JSON: line 1 is unreadable up to its newline, and line 2 has the titles.",
        DRIVE_JSON.take(60) + nuls(20) + DRIVE_JSON.drop(80) + "\n" + DRIVE_TITLES + "1,auto,12\n",
        bag(
            topic("Time", cells = cells(1)),
            mode("auto"),
            topic("Volts", cells = cells(12)),
            problems = listOf(HEADER_UNREADABLE at 1, NUL_HOLE at 1),
        ),
    ),
    case(
        "nul-after-line-1",
        "A hole took line 2: line 1 knows the topics, and rows with as many cells are theirs.",
        DRIVE_JSON + "\n" + nuls(30) + "2,teleop,11\n3,teleop,10\n",
        bag(time(2, 3), mode("teleop", "teleop"), volts(11, 10), problems = listOf(NUL_HOLE at 2)),
    ),
    case(
        "nul-in-line-2",
        "A hole from the titles into a row: line 1 knows the topics; the rest of that row is dropped.",
        "$DRIVE_JSON\nTime,Mo" + nuls(30) + "11\n3,teleop,10\n",
        bag(time(3), mode("teleop"), volts(10), problems = listOf(NUL_HOLE at 2, ROW_CUT at 2)),
    ),
    case(
        "nul-after-the-json",
        "A hole right behind the JSON, before its newline: the header is whole.",
        DRIVE_JSON + nuls(30) + "11\n3,teleop,10\n",
        bag(time(3), mode("teleop"), volts(10), problems = listOf(NUL_HOLE at 1, ROW_CUT at 1)),
    ),
    case(
        "nul-after-lines-1-and-2",
        "Header, then NULs to the end: not one row.",
        DRIVE + nuls(30),
        bag(time(), mode(), volts(), problems = listOf(NUL_HOLE at 3, NO_ROWS.anywhere)),
    ),
)
