package badlog.core.conformance

import badlog.core.recording.ProblemKind.BLANK_LINE
import badlog.core.recording.ProblemKind.BYTE_ORDER_MARK
import badlog.core.recording.ProblemKind.COLUMN_WITHOUT_TOPIC
import badlog.core.recording.ProblemKind.DUPLICATE_TOPIC
import badlog.core.recording.ProblemKind.EMPTY_FILE
import badlog.core.recording.ProblemKind.HEADER_UNREADABLE
import badlog.core.recording.ProblemKind.NAME_IN_DOUBT
import badlog.core.recording.ProblemKind.NOT_A_RECORDING
import badlog.core.recording.ProblemKind.NO_ROWS
import badlog.core.recording.ProblemKind.NUL_HOLE
import badlog.core.recording.ProblemKind.ROW_CUT
import badlog.core.recording.ProblemKind.TITLES_DAMAGED
import badlog.core.recording.ProblemKind.TOPIC_WITHOUT_COLUMN
import badlog.core.recording.ProblemKind.UNUSUAL_NAME
import badlog.core.recording.TopicKind.STATE
import badlog.core.recording.Value

/** Odd, missing and cut headers, and files that are not logs. */
internal val HEADER_CASES = listOf(
    case(
        "empty-file",
        "The robot was switched off before anything was written.",
        "",
        csv(problems = listOf(EMPTY_FILE.anywhere)),
    ),
    case(
        "blank-lines-only",
        "Newlines alone are as good as nothing.",
        "\n\n",
        csv(problems = listOf(BLANK_LINE at 1, BLANK_LINE at 2, EMPTY_FILE.anywhere)),
    ),
    case(
        "only-line-1",
        "The topics are known, and there is not one row.",
        DRIVE_JSON.replace("\"values\":[]", "\"values\":[{\"name\":\"Match\",\"value\":\"8\"}]") + "\n",
        bag(time(), mode(), volts(), values = listOf(Value("Match", "8")), problems = listOf(NO_ROWS.anywhere)),
    ),
    case(
        "only-line-1-without-newline",
        "The JSON is whole, so nothing is lost but the newline.",
        DRIVE_JSON,
        bag(time(), mode(), volts(), problems = listOf(NO_ROWS.anywhere)),
    ),
    case(
        "only-lines-1-and-2",
        "Not one row.",
        DRIVE,
        bag(time(), mode(), volts(), problems = listOf(NO_ROWS.anywhere)),
    ),
    case(
        "line-2-cut",
        "The power went while line 2 was written; line 1 knows all the topics that line 2 would have named.",
        "$DRIVE_JSON\nTime,Mo",
        bag(time(), mode(), volts(), problems = listOf(NO_ROWS.anywhere)),
    ),
    case(
        "line-1-cut-at-the-end",
        "The power went while line 1 was written: nothing of it is to be had.",
        DRIVE_JSON.take(60),
        bag(problems = listOf(HEADER_UNREADABLE at 1, NO_ROWS.anywhere)),
    ),
    case(
        "line-1-cut",
        "A cut line 1 is reported; line 2 is readable, so the rest is read as CSV, with rows that end in newlines.",
        DRIVE_JSON.take(60) + "\n" + DRIVE_TITLES + "1,auto,12\n",
        bag(
            topic("Time", cells = cells(1)),
            topic("Mode", kind = STATE, cells = cells("auto")),
            topic("Volts", cells = cells(12)),
            problems = listOf(HEADER_UNREADABLE at 1),
        ),
    ),
    case(
        "json-without-topics",
        "A JSON object that describes no topic is a header without topics; every column is reported, and has no unit.",
        """{"robot":"Fury","topics":"none"}""" + "\nTime,Volts\n1,12\n",
        bag(
            topic("Time", cells = cells(1)),
            topic("Volts", cells = cells(12)),
            problems = listOf(COLUMN_WITHOUT_TOPIC at 2 of "Time", COLUMN_WITHOUT_TOPIC at 2 of "Volts"),
        ),
    ),
    case(
        "topic-without-column",
        "A topic of line 1 that line 2 lacks is reported, and not shown.",
        "$DRIVE_JSON\nTime,Volts\n1,12\n",
        bag(time(1), volts(12), problems = listOf(TOPIC_WITHOUT_COLUMN at 2 of "Mode")),
    ),
    case(
        "column-without-topic",
        "A column that line 1 lacks is reported, and comes after the others, without unit and attributes.",
        DRIVE_JSON + "\nAmps,Time,Mode,Volts\n40,1,auto,12\n",
        bag(
            time(1),
            mode("auto"),
            volts(12),
            topic("Amps", cells = cells(40)),
            problems = listOf(COLUMN_WITHOUT_TOPIC at 2 of "Amps"),
        ),
    ),
    case(
        "duplicate-topics",
        "Topics with one name are both kept; the first belongs to the first column, the second is shown with a number.",
        """{"topics":[{"name":"A","unit":"V","attrs":[]},{"name":"B","unit":"s","attrs":[]},""" +
            """{"name":"A","unit":"A","attrs":["zero"]}],"values":[]}""" + "\nA,A,B\n1,2,3\n",
        bag(
            topic("A", "V", cells = cells(1)),
            topic("B", "s", cells = cells(3)),
            topic("A (2)", "A", listOf("zero"), cells = cells(2)),
            problems = listOf(DUPLICATE_TOPIC at 2 of "A (2)"),
        ),
    ),
    case(
        "duplicate-columns",
        "Columns of a CSV file with one title are numbered, around a title that has such a number itself.",
        "A,A (2),A,A\n1,2,3,4\n",
        csv(
            topic("A", cells = cells(1)),
            topic("A (2)", cells = cells(2)),
            topic("A (3)", cells = cells(3)),
            topic("A (4)", cells = cells(4)),
            problems = listOf(DUPLICATE_TOPIC at 1 of "A (3)", DUPLICATE_TOPIC at 1 of "A (4)"),
        ),
    ),
    case(
        "untitled-columns",
        "A column without a title is called after its place, counted from 1.",
        "Time,,Volts,\n1,2,3,4\n",
        csv(
            topic("Time", cells = cells(1)),
            topic("Column 2", cells = cells(2)),
            topic("Volts", cells = cells(3)),
            topic("Column 4", cells = cells(4)),
        ),
    ),
    case(
        "unusual-names",
        "Characters other than letters, digits, space, underscore and slash are reported; the name stays.",
        """{"topics":[{"name":"Arm_2/Angle","unit":"deg","attrs":[]},{"name":"Speed (max)","unit":"ul","attrs":[]},""" +
            """{"name":"Δ-Volts","unit":"V","attrs":[]}],"values":[]}""" +
            "\nArm_2/Angle,Speed (max),Δ-Volts\n1,2,3\n",
        bag(
            topic("Arm_2/Angle", "deg", cells = cells(1)),
            topic("Speed (max)", cells = cells(2)),
            topic("Δ-Volts", "V", cells = cells(3)),
            problems = listOf(UNUSUAL_NAME at 2 of "Speed (max)", UNUSUAL_NAME at 2 of "Δ-Volts"),
        ),
    ),
    case(
        "comma-in-a-name",
        "The original does not quote names on line 2; where that line is the names of line 1 with commas, it is them.",
        """{"topics":[{"name":"Speed, left","unit":"m/s","attrs":[]},{"name":"Time","unit":"s","attrs":[]}],""" +
            """"values":[]}""" + "\nSpeed, left,Time\n1.5,2\n",
        bag(
            topic("Speed, left", "m/s", cells = cells(1.5)),
            topic("Time", "s", cells = cells(2)),
            problems = listOf(UNUSUAL_NAME at 2 of "Speed, left"),
        ),
    ),
    case(
        "titles-lost-a-comma",
        "Line 2 has one title too few for the rows, line 1 has the right number: its names are those of the columns.",
        "$DRIVE_JSON\nTime-Mode,Volts\n1,auto,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(TITLES_DAMAGED at 2)),
    ),
    case(
        "titles-torn-by-a-newline",
        "What a newline has torn off the titles is not a row: it holds no number and lacks the cells of one.",
        "$DRIVE_JSON\nTime,Mo\nde,Volts\n1,auto,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(TITLES_DAMAGED at 2)),
    ),
    case(
        "titles-missing",
        "Line 2 is lost with its newline, so the second line is a row; line 1 has as many names as it has cells.",
        "$DRIVE_JSON\n1,auto,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(TITLES_DAMAGED at 2)),
    ),
    case(
        "title-unlike-its-name",
        "A title that differs from line 1, in as many columns: the name of line 1 is used, and in doubt.",
        "$DRIVE_JSON\nTime,Mofe,Volts\n1,auto,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(NAME_IN_DOUBT at 2 of "Mode")),
    ),
    case(
        "title-like-another-name",
        "A damaged title that is another topic's name does not take that topic's place.",
        "$DRIVE_JSON\nTime,Time,Volts\n1,auto,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(NAME_IN_DOUBT at 2 of "Mode")),
    ),
    case(
        "titles-reordered-and-damaged",
        "Line 2 had an order of its own and has lost a comma, so that it is not known which column is which: all are in doubt.",
        "$DRIVE_JSON\nVolts,Time-Mode\n12,1,auto\n11,2,teleop\n",
        bag(
            topic("Time", "s", cells = cells(1, 2)),
            topic("Mode", kind = STATE, cells = cells("auto", "teleop")),
            topic("Volts", "V", cells = cells(12, 11)),
            problems = listOf(
                TITLES_DAMAGED at 2,
                NAME_IN_DOUBT at 2 of "Time",
                NAME_IN_DOUBT at 2 of "Mode",
                NAME_IN_DOUBT at 2 of "Volts",
            ),
        ),
    ),
    case(
        "titles-of-csv-do-not-fit",
        "A CSV file whose rows all have more cells than titles: each keeps them, and every name is in doubt.",
        "Time-Volts,Mode\n1,12,auto\n2,11,teleop\n3,10,teleop\n",
        csv(
            topic("Time-Volts", cells = cells(1, 2, 3)),
            topic("Mode", cells = cells(12, 11, 10)),
            topic("Column 3", kind = STATE, cells = cells("auto", "teleop", "teleop")),
            problems = listOf(
                NAME_IN_DOUBT at 1 of "Time-Volts",
                NAME_IN_DOUBT at 1 of "Mode",
                NAME_IN_DOUBT at 1 of "Column 3",
            ),
        ),
    ),
    case(
        "remarks-before-the-titles",
        "The first line that has a text in each of the rows' cells has the titles; what stands before it is skipped.",
        "Robot,1014\nFury\nTime,Volts,Mode\n1,12,auto\n2,11,teleop\n3,10,teleop\n",
        csv(
            topic("Time", cells = cells(1, 2, 3)),
            topic("Volts", cells = cells(12, 11, 10)),
            topic("Mode", kind = STATE, cells = cells("auto", "teleop", "teleop")),
            problems = listOf(HEADER_UNREADABLE at 1),
        ),
    ),
    case(
        "control-character-in-a-title",
        "A byte that no text has does not refuse the rows after it; it is shown as a blank, and the title is in doubt.",
        "Time,Vo\u0003lts\n1,12\n2,11\n",
        csv(
            topic("Time", cells = cells(1, 2)),
            topic("Vo lts", cells = cells(12, 11)),
            problems = listOf(NAME_IN_DOUBT at 1 of "Vo lts"),
        ),
    ),
    case(
        "first-byte-damaged",
        "The brace of line 1 is damaged: line 2 has the titles, and the file is a bag all the same.",
        "[" + DRIVE.drop(1) + "1,auto,12\n2,teleop,11\n3,teleop,10\n",
        bag(
            topic("Time", cells = cells(1, 2, 3)),
            mode("auto", "teleop", "teleop"),
            topic("Volts", cells = cells(12, 11, 10)),
            problems = listOf(HEADER_UNREADABLE at 1),
        ),
    ),
    case(
        "nul-and-control-characters-in-line-1",
        "What a hole has left of line 1 may hold any bytes; line 2 has the titles.",
        DRIVE_JSON.take(60) + "\u0000ab\u0003" + DRIVE_JSON.drop(64) + "\n" + DRIVE_TITLES + "1,auto,12\n",
        bag(
            topic("Time", cells = cells(1)),
            mode("auto"),
            topic("Volts", cells = cells(12)),
            problems = listOf(HEADER_UNREADABLE at 1, NUL_HOLE at 1),
        ),
    ),
    case(
        "nul-in-the-middle-of-line-2",
        "A hole inside the titles: line 1 knows the topics; what is left of the titles is dropped.",
        "$DRIVE_JSON\nTime,M\u0000\u0000\u0000Volts\n1,auto,12\n2,teleop,11\n",
        bag(time(1, 2), mode("auto", "teleop"), volts(12, 11), problems = listOf(NUL_HOLE at 2, ROW_CUT at 2)),
    ),
    case(
        "byte-order-mark",
        "An editor on Windows put a byte order mark before the JSON.",
        "\uFEFF" + POWER + "1,12\n",
        bag(time(1), volts(12), problems = listOf(BYTE_ORDER_MARK at 1)),
    ),
    case(
        "byte-order-mark-csv",
        "A byte order mark does not become part of the first title.",
        "\uFEFFTime,Volts\n1,12\n",
        csv(
            topic("Time", cells = cells(1)),
            topic("Volts", cells = cells(12)),
            problems = listOf(BYTE_ORDER_MARK at 1),
        ),
    ),
    case(
        "blank-lines",
        "Blank lines are skipped wherever they stand, each is reported, and lines are counted with them.",
        "\n$DRIVE_JSON\n\n${DRIVE_TITLES}1,auto,12\n\n\n2,teleop,11\n\n",
        bag(
            time(1, 2),
            mode("auto", "teleop"),
            volts(12, 11),
            problems = listOf(1, 3, 6, 7, 9).map { BLANK_LINE at it },
        ),
    ),
    bytesCase(
        "binary",
        "Bytes that no text has, on line 1: not a log.",
        "\u007fELF\u0002\u0001\u0001\u0003\u0010 \u00ff\u00fe\n\u0001\u0002\n",
        csv(problems = listOf(NOT_A_RECORDING at 1)),
    ),
    case(
        "prose",
        "A text without a column of numbers or a second column is not a log: one clear error, and nothing to show.",
        "Dear pit crew\nplease charge the batteries\nthank you\n",
        csv(problems = listOf(NOT_A_RECORDING at 1)),
    ),
)
