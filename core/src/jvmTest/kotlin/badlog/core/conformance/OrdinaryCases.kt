package badlog.core.conformance

import badlog.core.recording.ProblemKind.EMPTY_CELLS
import badlog.core.recording.TopicKind.EMPTY
import badlog.core.recording.TopicKind.STATE
import badlog.core.recording.Value

/** Files with nothing wrong in them. */
internal val ORDINARY_CASES = listOf(
    case(
        "white-paper",
        "The example of the white paper, with its JSON on one line.",
        """{"values":[{"name":"Match Number","value":"8"}],"topics":[{"name":"Match Time","unit":"s","attrs":[]},""" +
            """{"name":"Random Numbers","unit":"ul","attrs":["integrate"]}]}""" + "\n" +
            "Match Time,Random Numbers\n15.000,0.53124\n14.980,0.70710\n14.960,0.011235\n",
        bag(
            topic("Match Time", "s", cells = cells(15.0, 14.98, 14.96)),
            topic("Random Numbers", attributes = listOf("integrate"), cells = cells(0.53124, 0.7071, 0.011235)),
            values = listOf(Value("Match Number", "8")),
        ),
    ),
    case(
        "json-escapes",
        "JSON escapes are undone, also the slashes that the original escapes; the titles of line 2 know no escapes.",
        """{"topics":[{"name":"Drive\/Left \u0041","unit":"m\/s","attrs":["join:Drive\/Speed"]}],""" +
            """"values":[{"name":"Notes\/Pit","value":"\"quick\" \\ swap\tof\nthe battery \u00b0 \ud83d\udd0b"}]}""" +
            "\nDrive/Left A\n1.5000\n",
        bag(
            topic("Drive/Left A", "m/s", listOf("join:Drive/Speed"), cells = cells(1.5)),
            values = listOf(Value("Notes/Pit", "\"quick\" \\ swap\tof\nthe battery ° \uD83D\uDD0B")),
        ),
    ),
    case(
        "unknown-keys",
        "Keys in any order; those that the format does not know are ignored, at every level.",
        """{"version":3,"values":[{"value":"8","hint":{"a":[1]},"name":"Match"}],"robot":{"team":1014},""" +
            """"topics":[{"attrs":["zero"],"color":"red","unit":"A","name":"Amps","range":[0,40]}]}""" + "\nAmps\n12\n",
        bag(topic("Amps", "A", listOf("zero"), cells = cells(12)), values = listOf(Value("Match", "8"))),
    ),
    case(
        "missing-unit-and-attributes",
        "A topic without unit is unitless, one without attrs has none; a header without values has none.",
        """{"topics":[{"name":"A"},{"name":"B","unit":"V"},{"name":"C","attrs":["zero"]}]}""" + "\nA,B,C\n1,2,3\n",
        bag(
            topic("A", cells = cells(1)),
            topic("B", "V", cells = cells(2)),
            topic("C", attributes = listOf("zero"), cells = cells(3)),
        ),
    ),
    case(
        "empty-unit",
        "An empty unit is kept as the file has it; it means none.",
        """{"topics":[{"name":"A","unit":"","attrs":[]}],"values":[{"name":"Empty","value":""}]}""" + "\nA\n1\n",
        bag(topic("A", "", cells = cells(1)), values = listOf(Value("Empty", ""))),
    ),
    case(
        "column-order",
        "Columns belong to topics by name, not by place; topics come in the order of line 1.",
        """{"topics":[{"name":"A","unit":"V","attrs":[]},{"name":"B","unit":"A","attrs":[]},""" +
            """{"name":"C","unit":"s","attrs":[]}],"values":[]}""" + "\nC,A,B\n3,1,2\n30,10,20\n",
        bag(
            topic("A", "V", cells = cells(1, 10)),
            topic("B", "A", cells = cells(2, 20)),
            topic("C", "s", cells = cells(3, 30)),
        ),
    ),
    case(
        "quoted-cells",
        "Quotes as RFC 4180 has them: around commas, doubled inside, and where none are needed.",
        DRIVE + "1,\"auto, left\",12\n2,\"the \"\"good\"\" one\",\"11.5\"\n\"3\",\"\"\"\"\"\",11\n4,\"\",10.5\n",
        bag(
            time(1, 2, 3, 4),
            mode("auto, left", "the \"good\" one", "\"\"", null),
            volts(12, 11.5, 11, 10.5),
        ),
    ),
    case(
        "quoted-newlines",
        "A quoted cell may hold newlines and blank lines; they are part of its text and make no row.",
        DRIVE + "1,\"auto\nleft\",12\n2,\"a\n\nb, c\n\",11\n3,teleop,10\n",
        bag(time(1, 2, 3), mode("auto\nleft", "a\n\nb, c\n", "teleop"), volts(12, 11, 10)),
    ),
    case(
        "quoted-lines-like-rows",
        "Lines of a quoted text may have as many cells as a row; with text where the row has a number they are none.",
        """{"topics":[{"name":"Time","unit":"s","attrs":[]},{"name":"Log","unit":"ul","attrs":["log"]}],""" +
            """"values":[]}""" + "\nTime,Log\n1,\"Error\nat turn(Drive, 12)\nat run(Robot, 80)\"\n2,ok\n",
        bag(
            time(1, 2),
            topic(
                "Log",
                attributes = listOf("log"),
                kind = STATE,
                cells = cells("Error\nat turn(Drive, 12)\nat run(Robot, 80)", "ok"),
            ),
        ),
    ),
    case(
        "one-column",
        "One topic: no row has a comma, and a cell without anything is written as two quotes.",
        """{"topics":[{"name":"A","unit":"V","attrs":[]}],"values":[]}""" + "\nA\n1.5\n\"\"\n-2\n",
        bag(topic("A", "V", cells = cells(1.5, null, -2)), problems = listOf(EMPTY_CELLS of "A")),
    ),
    case(
        "unicode",
        "Everything is UTF-8, names, units, values and texts; letters of any script are letters.",
        """{"topics":[{"name":"Temps/Été","unit":"°C","attrs":[]},{"name":"状態","unit":"µ","attrs":[]}],""" +
            """"values":[{"name":"Fahrer","value":"Jürgen 🤖"}]}""" +
            "\nTemps/Été,状態\n21.5,走行 🤖\n22,\"arrêt, fin\"\n",
        bag(
            topic("Temps/Été", "°C", cells = cells(21.5, 22)),
            topic("状態", "µ", kind = STATE, cells = cells("走行 🤖", "arrêt, fin")),
            values = listOf(Value("Fahrer", "Jürgen 🤖")),
        ),
    ),
    case(
        "folders",
        "Slashes make folders where a log is shown; in the data a name stays as it is, slash at its beginning and all.",
        """{"topics":[{"name":"/Arm/Angle","unit":"deg","attrs":[]},{"name":"Arm/","unit":"ul","attrs":[]}],""" +
            """"values":[{"name":"/PID/P","value":"0.1"}]}""" + "\n/Arm/Angle,Arm/\n1,2\n",
        bag(
            topic("/Arm/Angle", "deg", cells = cells(1)),
            topic("Arm/", cells = cells(2)),
            values = listOf(Value("/PID/P", "0.1")),
        ),
    ),
    case(
        "csv",
        "A CSV file is a bag without units, attributes and values, and its last row need not end in a newline.",
        "Time,Speed (m/s)\n0.02,1.5\n0.04,1.75",
        csv(topic("Time", cells = cells(0.02, 0.04)), topic("Speed (m/s)", cells = cells(1.5, 1.75))),
    ),
    case(
        "quoted-titles",
        "Titles on line 2 may be quoted like any cell.",
        "\"Time\",\"Left, front\",\"the \"\"good\"\" one\"\n1,2,3\n",
        csv(
            topic("Time", cells = cells(1)),
            topic("Left, front", cells = cells(2)),
            topic("the \"good\" one", cells = cells(3)),
        ),
    ),
    case(
        "no-cells-in-a-topic",
        "A topic whose cells are all empty is there, and is empty.",
        POWER + "1,\n2,null\n",
        bag(time(1, 2), topic("Volts", "V", kind = EMPTY, cells = cells(null, null))),
    ),
)
