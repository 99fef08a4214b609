import "../viewer";
