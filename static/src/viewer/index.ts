export * from "./motion_viewer";
export * from "./thumbnails";
